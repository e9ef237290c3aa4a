//! Items that are generic over types and sizes, in several instances.

use bessemer::prelude::*;

/// The coefficients of a second-order filter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients<T> {
    /// Coefficients of the inputs, newest first.
    pub b: [T; 3],
    /// Coefficients of the outputs, newest first.
    pub a: [T; 2],
}

/// A second-order filter in direct form.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Biquad<T> {
    /// Coefficients of the filter.
    pub coefficients: Coefficients<T>,
    /// Past inputs and outputs.
    pub x: [T; 2],
    pub y: [T; 2],
}

#[data]
impl<T: Real> Coefficients<T> {
    /// A low-pass filter whose cutoff is `ratio` times the sample rate.
    pub fn low_pass(ratio: T, quality: T) -> Self {
        let angle = T::TAU * ratio;
        let alpha = angle.sin() / (real::<T>(2.0) * quality);
        let scale = T::ONE / (T::ONE + alpha);
        let b = (T::ONE - angle.cos()) * real(0.5) * scale;
        Coefficients {
            b: [b, b * real(2.0), b],
            a: [real::<T>(-2.0) * angle.cos() * scale, (T::ONE - alpha) * scale],
        }
    }
}

#[component]
impl<T: Real> Biquad<T> {
    /// The next output.
    #[entry]
    pub fn step(&mut self, input: T) -> T {
        let Coefficients { b, a } = self.coefficients;
        let fed = dot(&b, &[input, self.x[0], self.x[1]]);
        let output = fed - dot(&a, &self.y);
        self.x = [input, self.x[0]];
        self.y = [output, self.y[0]];
        limited(output)
    }

    /// Sets the cutoff.
    #[entry]
    pub fn tune(&mut self, ratio: T) {
        self.coefficients = Coefficients::low_pass(ratio, T::ONE / real::<T>(2.0).sqrt());
    }
}

/// The filter in single precision.
#[component]
pub type BiquadF32 = Biquad<f32>;

#[component]
pub type BiquadF64 = Biquad<f64>;

/// The sum of the products.
#[function]
pub fn dot<T: Real, const N: usize>(a: &[T; N], b: &[T; N]) -> T {
    let mut sum = T::ZERO;
    for i in 0..N {
        sum += a[i] * b[i];
    }
    sum
}

#[function]
fn limited<T: Real>(x: T) -> T {
    if x.is_nan() { T::ZERO } else { x.clamp(T::MIN / real(4.0), T::MAX / real(4.0)) }
}

/// The last N values.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Delay<T: Copy + Default, const N: usize> {
    pub line: [T; N],
    pub next: usize,
}

impl<T: Copy + Default, const N: usize> Default for Delay<T, N> {
    fn default() -> Self {
        Delay { line: [T::default(); N], next: N - 1 }
    }
}

#[component]
impl<T: Copy + Default, const N: usize> Delay<T, N> {
    const FIRST: usize = N / 2;

    #[entry]
    pub fn push(&mut self, value: T) -> T {
        let old = self.line[self.next];
        self.line[self.next] = value;
        self.next = if self.next + 1 == N { 0 } else { self.next + 1 };
        old
    }

    #[entry]
    pub fn middle(&self) -> T {
        self.line[Self::FIRST]
    }
}

#[component]
pub type Delays = Delay<i16, 3>;

/// Contains instances, with and without type aliases.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bank {
    pub filters: [Biquad<f32>; 2],
    pub delay: Delay<f64, 5>,
    pub flags: Delay<bool, 2>,
    pub short: Delays,
}

#[function]
fn larger<T: PartialOrd + Copy>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

#[function]
fn scaled<T: Real, const R: usize, const C: usize>(
    m: &SMatrix<T, R, C>,
    by: T,
) -> SMatrix<T, R, C> {
    let mut scaled = *m * by;
    scaled[(0, 0)] = m[(0, 0)].abs().max(T::EPSILON);
    scaled
}

#[component]
impl Bank {
    #[entry]
    pub fn run(&mut self, x: f32, flag: bool, n: i16) -> f64 {
        let mut sum = 0.0;
        for filter in &mut self.filters {
            sum += filter.step(x);
        }
        let flag = self.flags.push(flag);
        let n = larger(self.short.push(n), self.short.middle());
        let late = self.delay.push(sum.as_f64() + f64::from(n));
        if flag { larger(late, 0.25) } else { dot(&[late, 2.0], &[0.5, larger(0.5, late)]) }
    }

    #[entry]
    pub fn scale(&mut self, m: &Matrix2<f32>, row: &SMatrix<f64, 1, 3>) -> f64 {
        let m = scaled(m, 0.1);
        let row = scaled(row, 0.1);
        m.dot(&m).as_f64() + row[(0, 2)] + row.norm()
    }
}
