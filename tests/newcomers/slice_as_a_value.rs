//! The middle of a message.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SliceAsAValue {
    pub last: u8,
}

#[component]
impl SliceAsAValue {
    #[entry]
    pub fn step(&mut self, bytes: &[u8; 8]) -> u8 {
        let middle = bytes[2..4];
        self.last = middle[0];
        self.last
    }
}
