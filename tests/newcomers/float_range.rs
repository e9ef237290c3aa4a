//! A loop over floats.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatRange {
    pub last: f64,
}

#[component]
impl FloatRange {
    #[entry]
    pub fn step(&mut self) -> f64 {
        for x in 0.0..1.0 {
            self.last += x;
        }
        self.last
    }
}
