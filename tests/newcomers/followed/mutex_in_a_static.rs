//! A setpoint shared by two tasks.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MutexSetpoint {
    pub setpoint: f64,
}

#[component]
impl MutexSetpoint {
    #[entry]
    pub fn step(&mut self) -> f64 {
        self.setpoint
    }
}
