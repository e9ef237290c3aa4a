//! The element before, as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NegativeIndex {
    pub values: [f64; 4],
}

#[component]
impl NegativeIndex {
    #[entry]
    pub fn step(&mut self, i: i32) -> f64 {
        self.values[(i - 1) as usize]
    }
}
