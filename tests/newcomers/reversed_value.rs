//! The elements from the last on.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ReversedValue {
    pub last: f64,
}

#[component]
impl ReversedValue {
    #[entry]
    pub fn step(&mut self, mut values: [f64; 4]) -> f64 {
        let back = values.reverse();
        self.last = back[0];
        self.last
    }
}
