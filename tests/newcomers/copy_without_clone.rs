//! A pair that is copied.
use bessemer::prelude::*;

#[data]
#[derive(Copy)]
pub struct Pair {
    pub a: f64,
    pub b: f64,
}

#[component]
#[derive(Default)]
pub struct CopyWithoutClone {
    pub last: f64,
}

#[component]
impl CopyWithoutClone {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
