//! A counter, as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IncrementOperator {
    pub count: u8,
}

#[component]
impl IncrementOperator {
    #[entry]
    pub fn step(&mut self) -> u8 {
        self.count++;
        self.count
    }
}
