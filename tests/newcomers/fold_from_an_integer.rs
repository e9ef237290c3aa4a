//! A sum by `fold`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FoldFromAnInteger {
    pub last: f64,
}

#[component]
impl FoldFromAnInteger {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = values.iter().fold(0, |sum, x| sum + x);
        self.last
    }
}
