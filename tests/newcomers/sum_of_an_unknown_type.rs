//! A mean.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SumOfAnUnknownType {
    pub last: f64,
}

#[component]
impl SumOfAnUnknownType {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        let mean = values.iter().sum() / 4.0;
        self.last = mean;
        self.last
    }
}
