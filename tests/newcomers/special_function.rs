//! The gamma function.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SpecialFunction {
    pub last: f64,
}

#[component]
impl SpecialFunction {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.gamma();
        self.last
    }
}
