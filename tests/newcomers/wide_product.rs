//! A product of two words.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WideProduct {
    pub last: u64,
}

#[component]
impl WideProduct {
    #[entry]
    pub fn step(&mut self, x: u64) -> u64 {
        self.last = ((u128::from(x) * u128::from(x)) >> 64) as u64;
        self.last
    }
}
