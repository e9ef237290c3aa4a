//! A sum of the positive elements.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FilterWithoutDereference {
    pub last: f64,
}

#[component]
impl FilterWithoutDereference {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        self.last = values.iter().filter(|x| x > 0.0).sum::<f64>();
        self.last
    }
}
