//! The attribute on the impl alone.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnmarkedState {
    pub last: f64,
}

#[component]
impl UnmarkedState {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
