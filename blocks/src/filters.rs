//! Recursive filters: sections of first and second order, their design, and cascades.
//!
//! Sections are designed by the bilinear transform, s = (2/h) (z − 1)/(z + 1), with the frequency prewarped where a
//! design has one, so that it is exact there. The design can run on the target, when a frequency follows a speed.
//!
//! A value that is NaN or infinite stays in a recursive filter until `Default` replaces it: check inputs before.
//!
//! Source: Oppenheim and Schafer, *Discrete-Time Signal Processing*, 3rd edition, sections 6.3 and 7.1.

use bessemer::prelude::*;

/// Coefficients of a section of first order: y(k) = b0 u(k) + b1 u(k−1) − a1 y(k−1).
///
/// ```
/// use bessemer_blocks::{FirstOrder, FirstOrderFilter};
///
/// // A low-pass with a time constant of 0.5 s at 1 s, and a lead-lag of gain 1 at rest and 2 at high frequency.
/// let low_pass = FirstOrder::low_pass(0.5, 1.0);
/// assert_eq!((low_pass.b0, low_pass.b1, low_pass.a1), (0.5, 0.5, 0.0));
/// let lead = FirstOrder::lead_lag(2.0, 1.0, 0.5_f64);
/// assert!((FirstOrderFilter::default().step(&lead, 1.0) - 1.8).abs() < 1e-15);
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FirstOrder<T> {
    /// Weight of the input.
    pub b0: T,
    /// Weight of the last input.
    pub b1: T,
    /// Weight of the last output, subtracted. Stable for −1 < a1 < 1.
    pub a1: T,
}

#[data]
impl<T: Real> FirstOrder<T> {
    /// Returns the low-pass 1/(τ s + 1): time constant τ in s, 0 or more; `period` h in s, above 0.
    pub fn low_pass(time_constant: T, period: T) -> Self {
        let twice = real::<T>(2.0) * time_constant;
        let scale = T::ONE / (twice + period);
        FirstOrder { b0: period * scale, b1: period * scale, a1: (period - twice) * scale }
    }

    /// Returns the high-pass τ s/(τ s + 1): time constant τ in s, above 0; `period` h in s, above 0.
    pub fn high_pass(time_constant: T, period: T) -> Self {
        let twice = real::<T>(2.0) * time_constant;
        let scale = T::ONE / (twice + period);
        FirstOrder { b0: twice * scale, b1: -twice * scale, a1: (period - twice) * scale }
    }

    /// Returns the lead-lag (τ₁ s + 1)/(τ₂ s + 1). `lead` τ₁ and `lag` τ₂ are in s, 0 or more; `period` h is in s, above 0.
    pub fn lead_lag(lead: T, lag: T, period: T) -> Self {
        let (above, below) = (real::<T>(2.0) * lead, real::<T>(2.0) * lag);
        let scale = T::ONE / (below + period);
        FirstOrder {
            b0: (above + period) * scale,
            b1: (period - above) * scale,
            a1: (period - below) * scale,
        }
    }
}

/// Filter of first order: low-pass, high-pass or lead-lag, by its coefficients (direct form II, transposed).
///
/// Initialisation: `Default` is at rest at 0; [`FirstOrderFilter::preset`] is at rest at a value. Nothing
/// saturates.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FirstOrderFilter<T> {
    /// Part of the next output that the past decides.
    past: T,
}

#[component]
impl<T: Real> FirstOrderFilter<T> {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, section: &FirstOrder<T>, sample: T) -> T {
        let output = section.b0 * sample + self.past;
        self.past = section.b1 * sample - section.a1 * output;
        output
    }

    /// Comes to rest at an output, for a constant input `sample`.
    #[entry(infallible)]
    pub fn preset(&mut self, section: &FirstOrder<T>, sample: T, output: T) {
        self.past = output - section.b0 * sample;
    }
}

/// Coefficients of a section of second order (a biquad):
/// y(k) = b0 u(k) + b1 u(k−1) + b2 u(k−2) − a1 y(k−1) − a2 y(k−2).
///
/// The designs have a frequency in Hz, above 0 and below half of `rate`, the samples per second, and a quality Q above
/// 0. A Butterworth low-pass of second order has Q = 1/√2; Q = 1/(2 ζ) for a damping ratio ζ.
///
/// ```
/// use bessemer_blocks::{Cascade, Section};
///
/// // A notch at 50 Hz passes a constant unchanged.
/// let notch = [Section::notch(50.0_f32, 5.0, 1000.0)];
/// let mut filter = Cascade::<f32, 1>::default();
/// let last = (0..1000).map(|_| filter.step(&notch, 3.0)).last().unwrap();
/// assert!((last - 3.0).abs() < 1e-5);
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section<T> {
    /// Weight of the input.
    pub b0: T,
    /// Weight of the last input.
    pub b1: T,
    /// Weight of the input before.
    pub b2: T,
    /// Weight of the last output, subtracted.
    pub a1: T,
    /// Weight of the output before, subtracted. Stable for |a2| < 1 and |a1| < 1 + a2.
    pub a2: T,
}

#[data]
impl<T: Real> Section<T> {
    /// Returns the section of (n0 + n1 s + n2 s²)/(1 + s/Q + s²), s in units of the frequency.
    pub fn of_analog(numerator: [T; 3], frequency: T, quality: T, rate: T) -> Self {
        // s = (z − 1)/(z + 1)/w after prewarping.
        let w = (T::PI * frequency / rate).tan();
        let (first, second) = (w / quality, w * w);
        let scale = T::ONE / (second + first + T::ONE);
        let [n0, n1, n2] = numerator;
        let (n0, n1) = (n0 * second, n1 * w);
        let two = real::<T>(2.0);
        Section {
            b0: (n0 + n1 + n2) * scale,
            b1: two * (n0 - n2) * scale,
            b2: (n0 - n1 + n2) * scale,
            a1: two * (second - T::ONE) * scale,
            a2: (second - first + T::ONE) * scale,
        }
    }

    /// Returns the low-pass 1/(1 + s/Q + s²): gain 1 at rest.
    pub fn low_pass(frequency: T, quality: T, rate: T) -> Self {
        Section::of_analog([T::ONE, T::ZERO, T::ZERO], frequency, quality, rate)
    }

    /// Returns the high-pass s²/(1 + s/Q + s²): gain 1 at high frequency.
    pub fn high_pass(frequency: T, quality: T, rate: T) -> Self {
        Section::of_analog([T::ZERO, T::ZERO, T::ONE], frequency, quality, rate)
    }

    /// Returns the band-pass (s/Q)/(1 + s/Q + s²): gain 1 at the frequency.
    pub fn band_pass(frequency: T, quality: T, rate: T) -> Self {
        Section::of_analog([T::ZERO, T::ONE / quality, T::ZERO], frequency, quality, rate)
    }

    /// Returns the notch (1 + s²)/(1 + s/Q + s²): gain 0 at the frequency, 1 at rest and at high frequency.
    pub fn notch(frequency: T, quality: T, rate: T) -> Self {
        Section::of_analog([T::ONE, T::ZERO, T::ONE], frequency, quality, rate)
    }
}

/// Cascade of `N` sections in direct form II, transposed: two values of state for each section.
///
/// The usual choice for floats. Initialisation: `Default` is at rest at 0. Nothing saturates.
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cascade<T, const N: usize> {
    /// Two values of each section.
    states: [[T; 2]; N],
}

impl<T: Real, const N: usize> Default for Cascade<T, N> {
    fn default() -> Self {
        Cascade { states: [[T::ZERO; 2]; N] }
    }
}

#[component]
impl<T: Real, const N: usize> Cascade<T, N> {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, sections: &[Section<T>; N], sample: T) -> T {
        let mut value = sample;
        for (state, section) in self.states.iter_mut().zip(sections) {
            let output = section.b0 * value + state[0];
            state[0] = section.b1 * value - section.a1 * output + state[1];
            state[1] = section.b2 * value - section.a2 * output;
            value = output;
        }
        value
    }

    /// Sets the state as if the input had always been `sample`: no transient follows. It is not finite for a section
    /// with a pole at rest, such as an integrator.
    #[entry(infallible)]
    pub fn preset(&mut self, sections: &[Section<T>; N], sample: T) {
        let mut value = sample;
        for (state, section) in self.states.iter_mut().zip(sections) {
            let gain = (section.b0 + section.b1 + section.b2) / (T::ONE + section.a1 + section.a2);
            let output = gain * value;
            let second = section.b2 * value - section.a2 * output;
            *state = [section.b1 * value - section.a1 * output + second, second];
            value = output;
        }
    }

    /// Filters a block of samples in place, section by section. The bits equal those of single steps.
    pub fn block<const M: usize>(&mut self, sections: &[Section<T>; N], samples: &mut [T; M]) {
        for (state, section) in self.states.iter_mut().zip(sections) {
            let [mut first, mut second] = *state;
            for sample in samples.iter_mut() {
                let output = section.b0 * *sample + first;
                first = section.b1 * *sample - section.a1 * output + second;
                second = section.b2 * *sample - section.a2 * output;
                *sample = output;
            }
            *state = [first, second];
        }
    }
}

/// Cascade of `N` sections in direct form I: four values of state for each section.
///
/// The coefficients may change while it runs: the state is past inputs and outputs, whatever the coefficients were.
/// Initialisation: `Default` is at rest at 0. Nothing saturates.
///
/// ```
/// use bessemer_blocks::{CascadeDirect, Section};
///
/// let mut filter = CascadeDirect::<f64, 2>::default();
/// let sections = [Section::low_pass(10.0, 0.54, 100.0), Section::low_pass(10.0, 1.31, 100.0)];
/// let last = (0..200).map(|_| filter.step(&sections, 1.0)).last().unwrap();
/// assert!((last - 1.0).abs() < 1e-9);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CascadeDirect<T, const N: usize> {
    /// Past values of each section: input, input before, output, output before.
    states: [[T; 4]; N],
}

impl<T: Real, const N: usize> Default for CascadeDirect<T, N> {
    fn default() -> Self {
        CascadeDirect { states: [[T::ZERO; 4]; N] }
    }
}

#[component]
impl<T: Real, const N: usize> CascadeDirect<T, N> {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, sections: &[Section<T>; N], sample: T) -> T {
        let mut value = sample;
        for (state, section) in self.states.iter_mut().zip(sections) {
            let [x1, x2, y1, y2] = *state;
            let fed = section.b0 * value + section.b1 * x1 + section.b2 * x2;
            let output = fed - section.a1 * y1 - section.a2 * y2;
            *state = [value, x1, output, y1];
            value = output;
        }
        value
    }
}
