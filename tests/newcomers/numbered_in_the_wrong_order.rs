//! Numbered elements in a loop.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NumberedInTheWrongOrder {
    pub last: f64,
}

#[component]
impl NumberedInTheWrongOrder {
    #[entry]
    pub fn step(&mut self, values: [f64; 4]) -> f64 {
        for (x, i) in values.iter().enumerate() {
            self.last += x * 0.5 + i as f64;
        }
        self.last
    }
}
