//! The magnitude of a difference.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnsignedAbs {
    pub last: u32,
}

#[component]
impl UnsignedAbs {
    #[entry]
    pub fn step(&mut self, a: u32, b: u32) -> u32 {
        self.last = (a - b).abs();
        self.last
    }
}
