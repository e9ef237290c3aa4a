//! The product of two words of 64 bits, scaled.
use bessemer::prelude::*;


#[component]
#[derive(Default)]
pub struct ProductIn128Bits {
    pub last: u64,
}

#[component]
impl ProductIn128Bits {
    #[entry]
    pub fn step(&mut self, x: u64) -> u64 {
        self.last = ((u128::from(self.last) * u128::from(x)) >> 32) as u64;
        self.last
    }
}
