//! A setpoint shared by two tasks.
use bessemer::prelude::*;
use std::sync::Mutex;

static SETPOINT: Mutex<f64> = Mutex::new(0.0);

#[component]
#[derive(Default)]
pub struct MutexSetpoint {
    pub last: f64,
}

#[component]
impl MutexSetpoint {
    #[entry]
    pub fn step(&mut self) -> f64 {
        self.last = *SETPOINT.lock().unwrap();
        self.last
    }
}
