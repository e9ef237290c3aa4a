//! Two flags of a word.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LogicalAndOfBits {
    pub last: f64,
}

#[component]
impl LogicalAndOfBits {
    #[entry]
    pub fn step(&mut self, x: f64, flags: u8) -> f64 {
        if flags && 0x03 {
            self.last = x;
        }
        self.last
    }
}
