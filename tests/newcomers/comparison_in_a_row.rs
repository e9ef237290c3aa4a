//! A range, as in mathematics.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ComparisonInARow {
    pub last: f64,
}

#[component]
impl ComparisonInARow {
    #[entry]
    pub fn step(&mut self, x: f64) -> bool {
        self.last = x;
        0.0 < x < 1.0
    }
}
