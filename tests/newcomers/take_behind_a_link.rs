//! The first two squares.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TakeBehindALink {
    pub last: f64,
}

#[component]
impl TakeBehindALink {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 4]) -> f64 {
        self.last = samples.iter().map(|x| x * x).take(2).sum::<f64>();
        self.last
    }
}
