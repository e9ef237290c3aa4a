//! A sum over a parameter that is borrowed already.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SumOfBorrowed {
    pub last: f64,
}

#[component]
impl SumOfBorrowed {
    #[entry]
    pub fn step(&mut self, x: &[f64; 3]) -> f64 {
        self.last = 0.0;
        for x in &x {
            self.last += x;
        }
        self.last
    }
}
