//! A bit mask that cannot fail.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ShiftInAnInfallibleEntry {
    pub last: u32,
}

#[component]
impl ShiftInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, bit: u32) -> u32 {
        self.last = 1 << (bit & 31);
        self.last
    }
}
