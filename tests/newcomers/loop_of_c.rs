//! A loop as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LoopOfC {
    pub last: f64,
}

#[component]
impl LoopOfC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        for (int i = 0; i < 3; i++) {
            self.last += x;
        }
        self.last
    }
}
