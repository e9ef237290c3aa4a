//! Derivative and integral of a signal.

use bessemer::prelude::*;

/// Derivative with a filter of first order: s/(τ s + 1) by the backward difference.
///
/// d(k) = (τ d(k−1) + u(k) − u(k−1)) / (τ + h), for a time constant τ in s, 0 or more, and a period h in s, above 0.
///
/// Initialisation: the first sample has the derivative 0. Nothing saturates. An input that is not finite returns the
/// last derivative and changes nothing. Source: Åström and Hägglund, *Advanced PID Control*, 2006, section 13.
///
/// ```
/// let mut derivative = bessemer_blocks::Derivative::default();
/// assert_eq!([1.0, 1.5, 2.0].map(|sample| derivative.step(0.0, 0.5, sample)), [0.0, 1.0, 1.0]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Derivative<T> {
    /// The last derivative.
    slope: T,
    /// The last sample.
    before: T,
    /// True after the first sample.
    running: bool,
}

#[component]
impl<T: Real> Derivative<T> {
    /// Takes one sample; returns the derivative, in units of the sample per s.
    #[entry(infallible)]
    pub fn step(&mut self, #[unit("s")] time_constant: T, #[unit("s")] period: T, sample: T) -> T {
        if sample.is_finite() {
            if self.running {
                let change = sample - self.before;
                self.slope = (time_constant * self.slope + change) / (time_constant + period);
            }
            self.before = sample;
            self.running = true;
        }
        self.slope
    }
}

/// Limits of an [`Integrator`]. `Default` has no limits and a period of 1 s.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegratorParameters<T> {
    /// Lowest output.
    pub low: T,
    /// Highest output, not below the lowest.
    pub high: T,
    /// Period h, above 0.
    #[unit("s")]
    pub period: T,
}

impl<T: Real> Default for IntegratorParameters<T> {
    fn default() -> Self {
        IntegratorParameters { low: T::MIN, high: T::MAX, period: T::ONE }
    }
}

/// Integral by the trapezoidal rule: y(k) = y(k−1) + h/2 (u(k) + u(k−1)).
///
/// Saturation: the output, which is the state, is limited to `low` … `high`, so it leaves a limit at once.
/// Initialisation: `Default` begins at 0; the first sample adds nothing. [`Integrator::reset`] begins at a value. An
/// input that is not finite adds nothing.
///
/// ```
/// use bessemer_blocks::{Integrator, IntegratorParameters};
///
/// let parameters = IntegratorParameters { low: 0.0, high: 10.0, period: 2.0 };
/// let mut integrator = Integrator::default();
/// assert_eq!([1.0, 3.0, 9.0, -1.0].map(|sample| integrator.step(&parameters, sample)), [0.0, 4.0, 10.0, 10.0]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integrator<T> {
    /// The integral.
    sum: T,
    /// The last sample.
    before: T,
    /// True after the first sample.
    running: bool,
}

#[component]
impl<T: Real> Integrator<T> {
    /// Takes one sample; returns the integral, in units of the sample times s.
    #[entry(infallible)]
    pub fn step(&mut self, parameters: &IntegratorParameters<T>, sample: T) -> T {
        if sample.is_finite() {
            if self.running {
                let half = real::<T>(0.5) * parameters.period;
                let sum = self.sum + half * (sample + self.before);
                self.sum = sum.max(parameters.low).min(parameters.high);
            }
            self.before = sample;
            self.running = true;
        }
        self.sum
    }

    /// Begins at a value. The next sample adds nothing.
    #[entry(infallible)]
    pub fn reset(&mut self, value: T) {
        self.sum = value;
        self.running = false;
    }
}
