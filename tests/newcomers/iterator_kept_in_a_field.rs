//! An iterator as state.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct KeptIterator {
    pub steps: core::ops::Range<u8>,
    pub rest: core::iter::Rev<core::ops::Range<u8>>,
    pub last: f64,
}

#[component]
impl KeptIterator {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
