//! A step with `&self`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AssignmentThroughASharedSelf {
    pub last: f64,
}

#[component]
impl AssignmentThroughASharedSelf {
    #[entry]
    pub fn step(&self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
