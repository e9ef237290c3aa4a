//! A square, as in MATLAB.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CaretAsPower {
    pub last: f64,
}

#[component]
impl CaretAsPower {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x ^ 2;
        self.last
    }
}
