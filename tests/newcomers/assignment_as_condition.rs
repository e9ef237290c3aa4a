//! One `=` too few.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AssignmentAsCondition {
    pub last: u8,
}

#[component]
impl AssignmentAsCondition {
    #[entry]
    pub fn step(&mut self, code: u8) -> bool {
        self.last = code;
        if code = 3 { true } else { false }
    }
}
