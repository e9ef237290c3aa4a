//! Two fields that are cleared.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AssignmentInARow {
    pub first: f64,
    pub last: f64,
}

#[component]
impl AssignmentInARow {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.first = self.last = 0.0;
        self.first + x
    }
}
