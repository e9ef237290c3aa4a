//! A name with the zero that C expects.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ZeroTerminated {
    pub last: u8,
}

#[component]
impl ZeroTerminated {
    #[entry]
    pub fn step(&mut self, x: u8) -> u8 {
        let name = c"pump";
        self.last = x + name.count_bytes() as u8;
        self.last
    }
}
