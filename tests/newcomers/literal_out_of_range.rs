//! A byte that is too large.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LiteralOutOfRange {
    pub last: u8,
}

#[component]
impl LiteralOutOfRange {
    #[entry]
    pub fn step(&mut self, n: u8) -> u8 {
        self.last = n + 300u8;
        self.last
    }
}
