//! A filtered list.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Collecting {
    pub last: usize,
}

#[component]
impl Collecting {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 8]) -> usize {
        let good: Vec<f64> = samples.iter().copied().filter(|x| *x > 0.0).collect();
        self.last = good.len();
        self.last
    }
}
