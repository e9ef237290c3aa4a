//! A reset beside the step.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Resettable {
    pub sum: f64,
}

#[component]
impl Resettable {
    #[entry]
    pub fn reset(&mut self) {
        self.sum = 0.0;
    }

    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.sum += x;
        self.sum
    }
}
