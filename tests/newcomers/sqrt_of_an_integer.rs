//! The root of an integer.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IntegerRoot {
    pub last: u32,
}

#[component]
impl IntegerRoot {
    #[entry]
    pub fn step(&mut self, n: u32) -> u32 {
        self.last = n.sqrt();
        self.last
    }
}
