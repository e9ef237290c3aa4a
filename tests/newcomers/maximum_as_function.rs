//! The larger of two by a bare function.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MaximumAsFunction {
    pub last: f64,
}

#[component]
impl MaximumAsFunction {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = max(x, 0.0);
        self.last
    }
}
