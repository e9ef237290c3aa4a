//! Ranges in a match.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ComparisonInAPattern {
    pub last: f64,
}

#[component]
impl ComparisonInAPattern {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = match x {
            < 0.0 => -1.0,
            _ => 1.0,
        };
        self.last
    }
}
