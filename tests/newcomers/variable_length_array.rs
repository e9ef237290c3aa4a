//! An array as long as a parameter says.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VariableLengthArray {
    pub last: f64,
}

#[component]
impl VariableLengthArray {
    #[entry]
    pub fn step(&mut self, n: usize) -> f64 {
        let values = [0.0; n];
        self.last = values[0];
        self.last
    }
}
