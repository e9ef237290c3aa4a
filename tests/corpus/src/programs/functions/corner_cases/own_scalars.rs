//! An author's own scalar trait with methods named like those of numbers, implemented for both floats by a macro; and
//! bounds with conversions.

use bessemer::prelude::*;
use core::ops::{Add, Mul, Sub};

/// A number type of a filter.
#[interface]
pub trait Scalar:
    Copy + PartialOrd + Default + Add<Output = Self> + Mul<Output = Self> + Sub<Output = Self> + From<f32>
{
    /// 1.
    const ONE: Self;
    /// The sine.
    fn sin(self) -> Self;
    /// The magnitude.
    fn abs(self) -> Self;
    /// Limits the number to a range.
    fn clamp(&self, low: &Self, high: &Self) -> Self;
    /// Converts a number from double precision.
    fn of(x: f64) -> Self;
    /// The larger of two numbers.
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

macro_rules! scalars {
    ($($float:ident)*) => {$(
        #[data]
        impl Scalar for $float {
            const ONE: $float = 1.0;
            fn sin(self) -> $float {
                $float::sin(self)
            }
            fn abs(self) -> $float {
                self.abs()
            }
            fn clamp(&self, low: &$float, high: &$float) -> $float {
                if *self < *low { *low } else if *self > *high { *high } else { *self }
            }
            fn of(x: f64) -> $float {
                x as $float
            }
        }
    )*};
}

scalars! { f32 f64 }

/// A fixed-point number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Fixed(i32);

#[data]
impl Add for Fixed {
    type Output = Fixed;
    fn add(self, other: Fixed) -> Fixed {
        Fixed(self.0.wrapping_add(other.0))
    }
}

#[data]
impl Sub for Fixed {
    type Output = Fixed;
    fn sub(self, other: Fixed) -> Fixed {
        Fixed(self.0.wrapping_sub(other.0))
    }
}

#[data]
impl Mul for Fixed {
    type Output = Fixed;
    fn mul(self, other: Fixed) -> Fixed {
        Fixed((i64::from(self.0) * i64::from(other.0) >> 16) as i32)
    }
}

#[data]
impl From<f32> for Fixed {
    fn from(x: f32) -> Fixed {
        Fixed((x * 65536.0) as i32)
    }
}

#[data]
impl Scalar for Fixed {
    const ONE: Fixed = Fixed(1 << 16);
    fn sin(self) -> Fixed {
        Fixed(self.0 / 2)
    }
    fn abs(self) -> Fixed {
        Fixed(self.0.saturating_abs())
    }
    fn clamp(&self, low: &Fixed, high: &Fixed) -> Fixed {
        if *self < *low { *low } else { self.max(*high) }
    }
    fn of(x: f64) -> Fixed {
        Fixed((x * 65536.0) as i32)
    }
}

/// A filter for any of these number types.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter<T> {
    state: T,
    gain: T,
}

#[data]
impl<T: Scalar> Filter<T> {
    /// A filter with a gain.
    pub fn new(gain: T) -> Filter<T> {
        Filter { state: T::default(), gain }
    }

    /// Filters one sample.
    pub fn step(&mut self, x: T) -> T {
        let of = T::of;
        let limit = T::from(2.5_f32);
        self.state = self.state + (x - self.state) * self.gain * of(0.5);
        let size = self.state.abs().max(T::ONE);
        self.state.clamp(&of(-3.0), &limit).sin() * size
    }
}

/// Filters of three number types.
#[function]
pub fn filtered(x: f64, y: f32, z: i32) -> (f64, f32, i32) {
    let mut double = Filter::new(0.25);
    let mut single = Filter::new(0.75_f32);
    let mut fixed = Filter::new(Fixed::ONE);
    double.step(x);
    single.step(y);
    fixed.step(Fixed(z));
    (double.step(x.sin()), single.step(y.max(0.5)), fixed.step(Fixed(z).abs()).0)
}

/// A number that can be converted to `f64`.
#[function]
pub fn scaled<T: Into<f64>>(x: T, by: f64) -> f64 {
    let wide: f64 = x.into();
    wide * by
}

/// A conversion that may fail.
#[function]
pub fn narrowed<T: TryFrom<u32> + Default>(x: u32) -> T {
    T::try_from(x).unwrap_or_default()
}

/// A conversion from a byte.
#[function]
pub fn widened<T>(x: u8) -> T
where
    T: From<u8> + Add<Output = T> + Copy,
{
    T::from(x) + T::from(1)
}

/// Uses the conversions with several types.
#[function]
pub fn converted(a: f32, b: i32, c: u32) -> (f64, u8, u16, u32, f64) {
    let narrow: u8 = narrowed(c);
    (scaled(a, 2.0) + scaled(b, 0.5), narrow, narrowed(c), widened(narrow), widened(narrow))
}
