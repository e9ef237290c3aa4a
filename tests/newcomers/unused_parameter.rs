//! A parameter that is forgotten.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnusedParameter {
    pub last: f64,
}

#[component]
impl UnusedParameter {
    #[entry]
    pub fn step(&mut self, x: f64, period: f64) -> f64 {
        self.last = x;
        self.last
    }
}
