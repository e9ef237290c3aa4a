//! The last samples, as many as there are.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VecField {
    pub samples: Vec<f64>,
}

#[component]
impl VecField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.samples.push(x);
        self.samples.iter().sum()
    }
}
