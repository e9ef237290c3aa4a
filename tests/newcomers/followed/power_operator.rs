//! A square, as in Python.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PowerOperator {
    pub last: f64,
}

#[component]
impl PowerOperator {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.powi(2);
        self.last
    }
}
