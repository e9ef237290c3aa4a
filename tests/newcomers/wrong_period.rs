//! A constant of another type than its expression.
use bessemer::prelude::*;

const PERIOD: f64 = 1 / 100;

#[component]
#[derive(Default)]
pub struct WrongPeriod {
    pub last: f64,
}

#[component]
impl WrongPeriod {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last += x * PERIOD;
        self.last
    }
}
