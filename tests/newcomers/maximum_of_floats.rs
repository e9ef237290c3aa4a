//! The largest sample.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MaximumOfFloats {
    pub last: f64,
}

#[component]
impl MaximumOfFloats {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 5]) -> f64 {
        self.last = *samples.iter().max().unwrap();
        self.last
    }
}
