//! Signals that are true or false, and sensors that may fail: debounce, timer, watchdog, median and voter.
//!
//! Times are numbers of periods, so that they are exact: a time divided by the period.

use bessemer::prelude::*;

/// Debounced contact, and its edges.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// The debounced level.
    pub is_on: bool,
    /// True in the period in which the level became true.
    pub rose: bool,
    /// True in the period in which the level became false.
    pub fell: bool,
}

/// Debounce: the level changes after the contact had the other level for `periods` periods in a row.
///
/// Initialisation: `Default` is off. A number of 0 means 1: the level follows at once.
///
/// ```
/// let mut debounce = bessemer_blocks::Debounce::default();
/// let levels = [true, false, true, true, true].map(|contact| debounce.step(3, contact).is_on);
/// assert_eq!(levels, [false, false, false, false, true]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Debounce {
    /// The debounced level.
    is_on: bool,
    /// Periods for which the contact has had the other level.
    different: u32,
}

#[component]
impl Debounce {
    /// Advances one period.
    #[entry(infallible)]
    pub fn step(&mut self, periods: u32, contact: bool) -> Contact {
        self.different = if contact == self.is_on { 0 } else { self.different.saturating_add(1) };
        let changed = self.different > 0 && self.different >= periods;
        if changed {
            self.is_on = contact;
            self.different = 0;
        }
        Contact { is_on: self.is_on, rose: changed && contact, fell: changed && !contact }
    }
}

/// Timer with an on delay, the TON of IEC 61131-3.
///
/// The output is true as soon as the input has been true for `periods` periods, until the input is false.
/// It is a timeout, too: the input is the waiting. Initialisation: `Default` has waited for no period. The count
/// saturates at 2³² − 1 periods.
///
/// ```
/// let mut timer = bessemer_blocks::Timer::default();
/// assert_eq!([true, true, true, false].map(|waiting| timer.step(2, waiting)), [false, true, true, false]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timer {
    /// Periods for which the input has been true.
    elapsed: u32,
}

#[component]
impl Timer {
    /// Advances one period; returns true if the time is over.
    #[entry(infallible)]
    pub fn step(&mut self, periods: u32, waiting: bool) -> bool {
        self.elapsed = if waiting { self.elapsed.saturating_add(1) } else { 0 };
        waiting && self.elapsed >= periods
    }

    /// Returns the number of periods for which the input has been true.
    #[entry(infallible)]
    pub fn elapsed(&self) -> u32 {
        self.elapsed
    }
}

/// Watchdog: trips after more than `periods` periods in a row without a sign of life, and stays so until a reset.
///
/// Initialisation: `Default` counts from 0, so a peer that never reports trips it.
///
/// ```
/// let mut watchdog = bessemer_blocks::Watchdog::default();
/// let tripped = [true, false, false, true].map(|alive| watchdog.step(1, alive));
/// assert_eq!(tripped, [false, false, true, true]);
/// watchdog.reset();
/// assert!(!watchdog.step(1, true));
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Watchdog {
    /// Periods since the last sign of life.
    silent: u32,
    /// True after a timeout, until a reset.
    tripped: bool,
}

#[component]
impl Watchdog {
    /// Advances one period; returns true if it has tripped.
    #[entry(infallible)]
    pub fn step(&mut self, periods: u32, alive: bool) -> bool {
        self.silent = if alive { 0 } else { self.silent.saturating_add(1) };
        self.tripped |= self.silent > periods;
        self.tripped
    }

    /// Starts again.
    #[entry(infallible)]
    pub fn reset(&mut self) {
        *self = Watchdog::default();
    }
}

/// Median of three values. With one NaN it is one of the other two; with more it may be NaN.
///
/// ```
/// assert_eq!(bessemer_blocks::median(3.0, 9.0, 4.0), 4.0);
/// ```
#[function]
pub fn median<T: Real>(a: T, b: T, c: T) -> T {
    a.min(b).max(a.max(b).min(c))
}

/// Limits of a [`Voter`].
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VoterLimits<T> {
    /// Largest difference between a good sensor and the vote, 0 or more, in the sensors' unit.
    pub tolerance: T,
    /// Number of periods in a row with a larger difference after which a sensor has failed.
    pub periods: u32,
}

/// Result of a vote.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vote<T> {
    /// The voted value, in the sensors' unit. It keeps its value when no sensor is left.
    pub value: T,
    /// Number of sensors that have not failed.
    pub good: u8,
    /// True if two sensors are left that differ by more than twice the tolerance: the value is their mean.
    pub is_doubtful: bool,
}

/// Voter of three sensors: the median of three, the mean of two, the last one.
///
/// A sensor fails after `periods` periods in a row in which it differs from the vote by more than the
/// tolerance, or is NaN or infinite; it stays failed. The last sensor fails by a value that is not finite only.
/// Initialisation: `Default` trusts all three, with the value 0.
///
/// ```
/// use bessemer_blocks::{Voter, VoterLimits};
///
/// let limits = VoterLimits { tolerance: 0.5, periods: 2 };
/// let mut voter = Voter::default();
/// assert_eq!(voter.step(&limits, [1.0, 1.2, 9.0]).value, 1.2);
/// let vote = voter.step(&limits, [1.0, 1.2, 9.0]);
/// assert_eq!((vote.value, vote.good), (1.2, 2));
/// assert_eq!(voter.step(&limits, [1.0, 1.5, 9.0]).value, 1.25);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Voter<T> {
    /// The last vote.
    value: T,
    /// Periods in a row in which each sensor differed.
    wrong: [u32; 3],
    /// True for each sensor that has failed.
    failed: [bool; 3],
}

#[component]
impl<T: Real> Voter<T> {
    /// Votes once.
    #[entry(infallible)]
    pub fn step(&mut self, limits: &VoterLimits<T>, sensors: [T; 3]) -> Vote<T> {
        let [a, b, c] = sensors;
        let mut is_doubtful = false;
        let vote = match self.failed {
            [false, false, false] => median(a, b, c),
            [true, false, false] => middle(b, c),
            [false, true, false] => middle(a, c),
            [false, false, true] => middle(a, b),
            [false, true, true] => a,
            [true, false, true] => b,
            [true, true, false] => c,
            [true, true, true] => self.value,
        };
        if vote.is_finite() {
            self.value = vote;
        }
        let mut left = 0;
        for failed in &self.failed {
            if !*failed {
                left += 1;
            }
        }
        let mut good = 0;
        for ((wrong, failed), sensor) in self.wrong.iter_mut().zip(&mut self.failed).zip(sensors) {
            let off = (sensor - self.value).abs();
            let is_wrong = off > limits.tolerance || off.is_nan();
            if left == 2 && !*failed && is_wrong && sensor.is_finite() {
                // Two that differ: neither is known to be the wrong one.
                is_doubtful = true;
                *wrong = 0;
            } else if is_wrong {
                *wrong = wrong.saturating_add(1);
            } else {
                *wrong = 0;
            }
            if *wrong >= limits.periods.max(1) {
                *failed = true;
            }
            if !*failed {
                good += 1;
            }
        }
        Vote { value: self.value, good, is_doubtful }
    }

    /// Trusts all sensors again.
    #[entry(infallible)]
    pub fn reset(&mut self) {
        self.wrong = [0; 3];
        self.failed = [false; 3];
    }
}

/// Returns the mean of two sensors, or the one that is finite.
#[function]
fn middle<T: Real>(a: T, b: T) -> T {
    if !a.is_finite() {
        b
    } else if !b.is_finite() {
        a
    } else {
        real::<T>(0.5) * (a + b)
    }
}
