//! A reader of bytes, which the firmware would make.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Reader<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
}

#[component]
#[derive(Default)]
pub struct Counter {
    pub sum: u32,
}

#[component]
impl Counter {
    #[entry]
    pub fn step(&mut self, reader: &Reader<'_>) -> u32 {
        self.sum += reader.bytes.len() as u32;
        self.sum
    }
}
