//! A loop as in Python.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct RangeOfPython {
    pub last: f64,
}

#[component]
impl RangeOfPython {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        for i in range(3) {
            self.last += x * f64::from(i);
        }
        self.last
    }
}
