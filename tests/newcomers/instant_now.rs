//! The time since the last call.
use bessemer::prelude::*;
use std::time::Instant;

#[component]
#[derive(Default)]
pub struct InstantNow {
    pub last: f64,
}

#[component]
impl InstantNow {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let start = Instant::now();
        self.last = x;
        self.last + start.elapsed().as_secs_f64()
    }
}
