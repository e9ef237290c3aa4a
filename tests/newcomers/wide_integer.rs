//! A product of 128 bits.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WideInteger {
    pub last: u64,
}

#[component]
impl WideInteger {
    #[entry]
    pub fn step(&mut self, a: u64, b: u64) -> u64 {
        self.last = ((a as u128 * b as u128) >> 64) as u64;
        self.last
    }
}
