//! A step whose attribute was forgotten.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WithoutEntry {
    pub last: f64,
}

#[component]
impl WithoutEntry {
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
