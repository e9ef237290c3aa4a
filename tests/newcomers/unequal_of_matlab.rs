//! Unequal as in MATLAB.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnequalOfMatlab {
    pub last: f64,
}

#[component]
impl UnequalOfMatlab {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x ~= 0.0 {
            self.last = x;
        }
        self.last
    }
}
