//! A loop over the elements by their number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LoopOverALength {
    pub values: [f64; 4],
}

#[component]
impl LoopOverALength {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        for i in self.values.len() {
            self.values[i] = x;
        }
        self.values[0]
    }
}
