//! `pow` of a float.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatPow {
    pub last: f64,
}

#[component]
impl FloatPow {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.pow(2);
        self.last
    }
}
