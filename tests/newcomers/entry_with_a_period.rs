//! A period in the attribute.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PeriodInEntry {
    pub last: f64,
}

#[component]
impl PeriodInEntry {
    #[entry(period = 0.01)]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
