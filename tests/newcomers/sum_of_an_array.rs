//! The sum of the elements.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SumOfAnArray {
    pub last: f64,
}

#[component]
impl SumOfAnArray {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = values.sum();
        self.last
    }
}
