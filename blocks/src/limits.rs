//! Limits of a signal: rate, change of the rate, saturation, dead band and hysteresis.

use bessemer::prelude::*;

/// Limits of a [`RateLimiter`]: of the signal's unit (U) and s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RateLimits<T> {
    /// Fastest rise, 0 or more, U/s.
    pub rise: T,
    /// Fastest fall, 0 or more, U/s.
    pub fall: T,
    /// Period h, above 0.
    #[unit("s")]
    pub period: T,
}

/// Rate limiter: y(k) is the target, at most h·rise above and h·fall below y(k−1).
///
/// Initialisation: `Default` begins at 0, [`RateLimiter::preset`] at a value. A target that is NaN changes
/// nothing; an infinite one is approached at the limit.
///
/// ```
/// use bessemer_blocks::{RateLimiter, RateLimits};
///
/// let limits = RateLimits { rise: 2.0, fall: 10.0, period: 0.5 };
/// let mut limiter = RateLimiter::default();
/// assert_eq!([1.5, 1.5, -9.0].map(|target| limiter.step(&limits, target)), [1.0, 1.5, -3.5]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RateLimiter<T> {
    /// The last output.
    output: T,
}

#[component]
impl<T: Real> RateLimiter<T> {
    /// Advances one period; returns the limited target.
    #[entry(infallible)]
    pub fn step(&mut self, limits: &RateLimits<T>, target: T) -> T {
        let highest = self.output + limits.rise * limits.period;
        let lowest = self.output - limits.fall * limits.period;
        if target > highest {
            self.output = highest;
        } else if target < lowest {
            self.output = lowest;
        } else if target.is_finite() {
            self.output = target;
        }
        self.output
    }

    /// Continues from a value.
    #[entry(infallible)]
    pub fn preset(&mut self, output: T) {
        self.output = output;
    }
}

/// Limits of a [`JerkLimiter`]: of the signal's unit (U) and s. All are above 0.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JerkLimits<T> {
    /// Fastest change of the signal, U/s.
    pub rate: T,
    /// Fastest change of its rate, U/s².
    pub acceleration: T,
    /// Period h.
    #[unit("s")]
    pub period: T,
}

/// A signal and its rate.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion<T> {
    /// The signal, U.
    pub value: T,
    /// Its rate of change, U/s.
    pub rate: T,
}

/// Jerk limiter: follows a target with a limited rate and a limited change of the rate. The overshoot is less than
/// acceleration · h².
///
/// For a set point of acceleration, the change of its rate is the jerk's; for a position, it is the acceleration. The
/// rate changes by h·fhan(y − target, rate), Han's time-optimal control of a double integrator in discrete time, then
/// it is limited: rate(k) = rate(k−1) + h·fhan, y(k) = y(k−1) + h·rate(k−1).
///
/// Initialisation: `Default` rests at 0, [`JerkLimiter::preset`] at a value. A target that is not finite
/// is replaced by the last output. Source: Han, *From PID to Active Disturbance Rejection Control*, IEEE Transactions
/// on Industrial Electronics 56 (3), 2009, equation (20).
///
/// ```
/// use bessemer_blocks::{JerkLimiter, JerkLimits};
///
/// let limits = JerkLimits { rate: 1.0, acceleration: 2.0, period: 0.01 };
/// let mut limiter = JerkLimiter::default();
/// let highest = (0..1000).map(|_| limiter.step(&limits, 3.0).value).fold(0.0, f64::max);
/// assert!((highest - 3.0).abs() < 1e-6);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JerkLimiter<T> {
    /// The last output.
    motion: Motion<T>,
}

#[component]
impl<T: Real> JerkLimiter<T> {
    /// Advances one period; returns the limited target and its rate.
    #[entry(infallible)]
    pub fn step(&mut self, limits: &JerkLimits<T>, target: T) -> Motion<T> {
        let period = limits.period;
        let Motion { value, rate } = self.motion;
        let away = if target.is_finite() { value - target } else { T::ZERO };
        let change = fastest(away, rate, limits.acceleration, period);
        let next = rate + period * change;
        self.motion =
            Motion { value: value + period * rate, rate: next.max(-limits.rate).min(limits.rate) };
        self.motion
    }

    /// Rests at a value.
    #[entry(infallible)]
    pub fn preset(&mut self, value: T) {
        self.motion = Motion { value, rate: T::ZERO };
    }
}

/// Returns Han's fhan: the acceleration, at most `most`, that brings `away` and its `rate` to 0 in the fewest periods.
#[function]
fn fastest<T: Real>(away: T, rate: T, most: T, period: T) -> T {
    let half = real::<T>(0.5);
    let d = most * period * period;
    let ahead = period * rate;
    let y = away + ahead;
    let root = (d * (d + real::<T>(8.0) * y.abs())).sqrt();
    let a = if y.abs() <= d { ahead + y } else { ahead + half * (root - d).copysign(y) };
    if a.abs() <= d { -most * a / d } else { -most.copysign(a) }
}

/// A limited value, and the limit that it is at.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Saturated<T> {
    /// The limited value.
    pub value: T,
    /// True if the value was below the lower limit, or NaN.
    pub is_low: bool,
    /// True if the value was above the upper limit.
    pub is_high: bool,
}

/// Saturation with flags: limits a value to `low` … `high`. NaN becomes `low`; with reversed limits the result is
/// `high`.
///
/// ```
/// let saturated = bessemer_blocks::saturated(7.0, -1.0, 5.0);
/// assert_eq!((saturated.value, saturated.is_low, saturated.is_high), (5.0, false, true));
/// ```
#[function]
pub fn saturated<T: Real>(value: T, low: T, high: T) -> Saturated<T> {
    let limited = value.max(low).min(high);
    Saturated { value: limited, is_low: value < low || value.is_nan(), is_high: value > high }
}

/// Dead band: 0 from −`width` to `width`, and the distance from the band outside it. The output is continuous; NaN
/// becomes 0.
///
/// ```
/// assert_eq!([-3.0, 0.5, 4.0].map(|value| bessemer_blocks::dead_band(value, 1.0)), [-2.0, 0.0, 3.0]);
/// ```
#[function]
pub fn dead_band<T: Real>(value: T, width: T) -> T {
    if value > width {
        value - width
    } else if value < -width {
        value + width
    } else {
        T::ZERO
    }
}

/// Hysteresis (a Schmitt trigger): on at `on` and above, off at `off` and below, unchanged between.
///
/// Initialisation: `Default` is off. Range: `on` is above `off`. NaN changes nothing.
///
/// ```
/// let mut heater_off = bessemer_blocks::Hysteresis::default();
/// let levels = [20.0, 22.5, 21.0, 19.0].map(|level| heater_off.step(22.0, 20.0, level));
/// assert_eq!(levels, [false, true, true, false]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hysteresis {
    /// The last output.
    is_on: bool,
}

#[component]
impl Hysteresis {
    /// Advances one period; returns true while on.
    pub fn step<T: Real>(&mut self, on: T, off: T, value: T) -> bool {
        if value >= on {
            self.is_on = true;
        } else if value <= off {
            self.is_on = false;
        }
        self.is_on
    }
}
