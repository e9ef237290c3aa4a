//! The period as a duration.
use bessemer::prelude::*;
use core::time::Duration;

#[component]
#[derive(Default)]
pub struct DurationParameter {
    pub integral: f64,
}

#[component]
impl DurationParameter {
    #[entry]
    pub fn step(&mut self, error: f64, period: Duration) -> f64 {
        self.integral += error * period.as_secs_f64();
        self.integral
    }
}
