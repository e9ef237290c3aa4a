//! A method that is called without `self`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NoSelf {
    pub last: f64,
}

#[component]
impl NoSelf {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = doubled(x);
        self.last
    }

    fn doubled(&self, x: f64) -> f64 {
        2.0 * x
    }
}
