//! Numbered elements in a closure.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PairAsTwoParameters {
    pub last: f64,
}

#[component]
impl PairAsTwoParameters {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = values.iter().enumerate().map(|i, x| x * i as f64).sum::<f64>();
        self.last
    }
}
