//! A median.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SortedFloats {
    pub last: f64,
}

#[component]
impl SortedFloats {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 5]) -> f64 {
        let mut sorted = *samples;
        sorted.sort();
        self.last = sorted[2];
        self.last
    }
}
