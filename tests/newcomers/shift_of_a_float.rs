//! Half by a shift.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatShift {
    pub last: f64,
}

#[component]
impl FloatShift {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x >> 1;
        self.last
    }
}
