//! A loop from 0 to 1 by tenths.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatRange {
    pub last: f64,
}

#[component]
impl FloatRange {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        for t in 0.0..1.0 {
            self.last += t * x;
        }
        self.last
    }
}
