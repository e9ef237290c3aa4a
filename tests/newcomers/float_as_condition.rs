//! A number as a condition.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatCondition {
    pub last: f64,
}

#[component]
impl FloatCondition {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x {
            self.last = 1.0;
        }
        self.last
    }
}
