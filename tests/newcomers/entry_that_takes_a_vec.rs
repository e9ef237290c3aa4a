//! Samples of any number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VecOfSamples {
    pub last: f64,
}

#[component]
impl VecOfSamples {
    #[entry]
    pub fn step(&mut self, samples: Vec<f64>) -> f64 {
        self.last = samples[0];
        self.last
    }
}
