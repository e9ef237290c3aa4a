//! A `return` that gives nothing.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EarlyReturnWithoutValue {
    pub last: f64,
}

#[component]
impl EarlyReturnWithoutValue {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x < 0.0 {
            return;
        }
        self.last = x;
        self.last
    }
}
