//! A word of a message.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WordFromASlice {
    pub last: u32,
}

#[component]
impl WordFromASlice {
    #[entry]
    pub fn step(&mut self, bytes: &[u8; 8]) -> u32 {
        self.last = u32::from_le_bytes(bytes[0..4]);
        self.last
    }
}
