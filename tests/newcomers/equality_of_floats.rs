//! A pair that is compared exactly.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Pair {
    pub a: f64,
    pub b: f64,
}

#[component]
#[derive(Default)]
pub struct EqualityOfFloats {
    pub last: f64,
}

#[component]
impl EqualityOfFloats {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
