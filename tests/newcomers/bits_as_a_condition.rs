//! A flag in a word.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BitsAsACondition {
    pub last: f64,
}

#[component]
impl BitsAsACondition {
    #[entry]
    pub fn step(&mut self, x: f64, flags: u8) -> f64 {
        if flags & 0x01 {
            self.last = x;
        }
        self.last
    }
}
