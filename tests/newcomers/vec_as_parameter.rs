//! Samples handed over.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VecParameter {
    pub sum: f64,
}

#[component]
impl VecParameter {
    #[entry]
    pub fn step(&mut self, samples: Vec<f64>) -> f64 {
        for x in samples {
            self.sum += x;
        }
        self.sum
    }
}
