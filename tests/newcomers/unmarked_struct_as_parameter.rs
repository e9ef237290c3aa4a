//! Gains in a struct of their own.
use bessemer::prelude::*;

pub struct Gains {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct UnmarkedParameter {
    pub error: f64,
}

#[component]
impl UnmarkedParameter {
    #[entry]
    pub fn step(&mut self, gains: &Gains, error: f64) -> f64 {
        self.error = error;
        gains.p * error
    }
}
