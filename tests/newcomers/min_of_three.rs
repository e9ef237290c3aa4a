//! The least of three by `min`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MinOfThree {
    pub last: f64,
}

#[component]
impl MinOfThree {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.min(1.0, 2.0);
        self.last
    }
}
