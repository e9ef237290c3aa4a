//! The largest element.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MaximumByACondition {
    pub last: f64,
}

#[component]
impl MaximumByACondition {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = *values.iter().max_by(|a, b| a > b).unwrap_or(&0.0);
        self.last
    }
}
