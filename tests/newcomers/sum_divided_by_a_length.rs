//! A mean by the number of elements.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SumDividedByALength {
    pub last: f64,
}

#[component]
impl SumDividedByALength {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = values.iter().sum::<f64>() / values.len();
        self.last
    }
}
