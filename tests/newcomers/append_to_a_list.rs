//! A value behind a list, as in Python.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AppendToAList {
    pub values: List<f64, 4>,
}

#[component]
impl AppendToAList {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.values.append(x);
        self.values[0]
    }
}
