//! A history that grows.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PushToAnArray {
    pub values: [f64; 4],
}

#[component]
impl PushToAnArray {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.values.push(x);
        self.values[0]
    }
}
