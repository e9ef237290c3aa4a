//! Time as whole ticks, so that rates never drift and simultaneous things are simultaneous.
//!
//! Knows nothing of what happens at a tick.

use std::num::{NonZeroU32, NonZeroU64};

use crate::error::{Error, checked, not_negative};

/// Latest time of a scenario, s: its nanoseconds fit into 64 bits.
const LONGEST: f64 = 1e9;
const LONGEST_RANGE: &str = "at most 10⁹ s";

/// Length of the base tick, a whole number of nanoseconds.
///
/// The time of tick k is k · tick / 10⁹ s, rounded once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tick(NonZeroU64);

impl Tick {
    /// Creates a tick of this length, ns.
    ///
    /// # Errors
    ///
    /// The length is 0.
    pub fn nanoseconds(length: u64) -> Result<Self, Error> {
        NonZeroU64::new(length).map(Self).ok_or(Error::Tick)
    }

    /// Returns the time of a tick, s.
    pub fn seconds(self, tick: u64) -> f64 {
        self.log_time(tick) as f64 / 1e9
    }

    /// Returns the time of a tick as recordings have it, ns; the latest possible time if it is beyond that.
    pub fn log_time(self, tick: u64) -> u64 {
        self.0.get().saturating_mul(tick)
    }

    /// Returns the first tick that is not before a time, s; `item` names the time in the error.
    pub(crate) fn not_before(self, item: &str, time: f64) -> Result<u64, Error> {
        let time = checked(item, not_negative(item, time)?, LONGEST_RANGE, time <= LONGEST)?;
        let near = (time * 1e9 / self.0.get() as f64).round() as u64;
        Ok(if self.seconds(near) < time { near.saturating_add(1) } else { near })
    }
}

/// A tick of this length, ns.
impl From<NonZeroU64> for Tick {
    fn from(length: NonZeroU64) -> Self {
        Self(length)
    }
}

/// Period of something, a whole number of ticks above 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Period(NonZeroU32);

impl Period {
    /// One tick.
    pub const TICK: Period = Period(NonZeroU32::MIN);

    /// Creates a period of some ticks.
    ///
    /// # Errors
    ///
    /// The number is 0.
    pub fn ticks(ticks: u32) -> Result<Self, Error> {
        NonZeroU32::new(ticks).map(Self).ok_or(Error::Period)
    }

    /// Returns true at the ticks 0, n, 2 n …
    pub(crate) fn is_due(self, tick: u64) -> bool {
        tick.is_multiple_of(u64::from(self.0.get()))
    }

    /// Returns the first due tick after a tick.
    pub(crate) fn next(self, tick: u64) -> u64 {
        let period = u64::from(self.0.get());
        (tick / period + 1) * period
    }

    /// Returns the length, s.
    pub(crate) fn seconds(self, tick: Tick) -> f64 {
        tick.seconds(u64::from(self.0.get()))
    }
}

/// A period of this number of ticks.
impl From<NonZeroU32> for Period {
    fn from(ticks: NonZeroU32) -> Self {
        Self(ticks)
    }
}
