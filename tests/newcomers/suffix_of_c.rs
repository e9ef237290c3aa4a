//! A literal as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SuffixOfC {
    pub last: f64,
}

#[component]
impl SuffixOfC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = 0.5f * x;
        self.last
    }
}
