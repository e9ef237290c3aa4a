//! The start of a message.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ByteComparedWithAChar {
    pub last: u8,
}

#[component]
impl ByteComparedWithAChar {
    #[entry]
    pub fn step(&mut self, bytes: &[u8; 8]) -> u8 {
        if bytes[0] == '$' {
            self.last = 1;
        }
        self.last
    }
}
