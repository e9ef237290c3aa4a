//! The attribute on the struct alone.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnmarkedImpl {
    pub last: f64,
}

#[component]
impl UnmarkedImpl {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
