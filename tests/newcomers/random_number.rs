//! Noise for a test signal.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct RandomNumber {
    pub last: f64,
}

#[component]
impl RandomNumber {
    #[entry]
    pub fn step(&mut self) -> f64 {
        self.last = rand::random::<f64>();
        self.last
    }
}
