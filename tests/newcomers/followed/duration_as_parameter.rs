//! The period as a duration.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DurationParameter {
    pub integral: f64,
}

#[component]
impl DurationParameter {
    #[entry]
    pub fn step(&mut self, error: f64, period: f64) -> f64 {
        self.integral += error * period;
        self.integral
    }
}
