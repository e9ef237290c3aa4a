//! Whether the processor's time goes forward, one period at a time.
//!
//! The software counts its own periods, so that a wrong clock moves nothing; but a clock that stands,
//! jumps or runs backwards for long says that the periods are not what they are taken for.

use bessemer::prelude::*;

/// So many wrong steps of the clock in a row are too many.
#[data]
const MOST_WRONG: u32 = 20;

/// Watches the clock.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClockMonitor {
    /// The last time, µs.
    pub last: u64,
    /// Whether there was one.
    pub running: bool,
    /// How many steps in a row were wrong.
    pub wrong: u32,
    /// How many were wrong in all.
    pub faults: u32,
}

#[component]
impl ClockMonitor {
    /// One period, s, at the end of which the clock shows `time`, µs: whether it can be relied on.
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, time: u64) -> bool {
        let forward = time > self.last && (time.wrapping_sub(self.last) as f64) < 3e6 * period;
        if self.running && !forward {
            self.wrong = self.wrong.saturating_add(1);
            self.faults = self.faults.saturating_add(1);
        } else {
            self.wrong = 0;
        }
        self.running = true;
        self.last = time;
        self.wrong < MOST_WRONG
    }
}
