//! Monitor of the processor's clock: each step must advance it by about one period.
//!
//! The software counts its own periods, so a wrong clock changes no result. A clock that stops, jumps or runs
//! backwards for long shows that the period is wrong.

use bessemer::prelude::*;

/// Number of consecutive wrong clock steps that raises the alarm.
#[requirement("HLR-39")]
#[data]
const WRONG_STEPS_LIMIT: u32 = 20;

/// Watches the clock.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClockMonitor {
    /// Last time, µs.
    pub last: u64,
    /// True after the first step.
    pub started: bool,
    /// Number of consecutive wrong steps.
    pub wrong: u32,
    /// Total number of wrong steps.
    pub faults: u32,
}

#[component]
impl ClockMonitor {
    /// Checks the clock's `time`, µs, after one period, s; returns false if the clock is unreliable.
    #[requirement("HLR-39")]
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, time: u64) -> bool {
        let forward = time > self.last && (time.wrapping_sub(self.last) as f64) < 3e6 * period;
        if self.started && !forward {
            self.wrong = self.wrong.saturating_add(1);
            self.faults = self.faults.saturating_add(1);
        } else {
            self.wrong = 0;
        }
        self.started = true;
        self.last = time;
        self.wrong < WRONG_STEPS_LIMIT
    }
}
