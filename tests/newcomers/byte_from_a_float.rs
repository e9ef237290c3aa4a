//! A percentage as a byte.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ByteFromAFloat {
    pub last: u8,
}

#[component]
impl ByteFromAFloat {
    #[entry]
    pub fn step(&mut self, x: f64) -> u8 {
        self.last = u8::from(x);
        self.last
    }
}
