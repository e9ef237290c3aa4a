//! An `Option` as a number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct OptionAsNumber {
    pub last: f64,
}

#[component]
impl OptionAsNumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let values = [x, 1.0];
        let first = values.first();
        self.last = first;
        self.last
    }
}
