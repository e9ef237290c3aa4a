//! Gains that are handed on by value.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Weights {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct MissingCopy {
    pub weights: Weights,
}

#[component]
impl MissingCopy {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let weights = [self.weights; 2];
        weights[1].p * x
    }
}
