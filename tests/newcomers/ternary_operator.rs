//! A choice, as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TernaryOperator {
    pub last: f64,
}

#[component]
impl TernaryOperator {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x > 0.0 ? x : 0.0;
        self.last
    }
}
