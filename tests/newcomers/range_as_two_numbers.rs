//! A gain between limits.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    #[range(0.0, 10.0)]
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct RangeAsTwoNumbers {
    pub last: f64,
}

#[component]
impl RangeAsTwoNumbers {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
