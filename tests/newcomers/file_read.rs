//! Parameters from a file.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FileRead {
    pub last: usize,
}

#[component]
impl FileRead {
    #[entry]
    pub fn step(&mut self) -> usize {
        self.last = std::fs::read("gains.txt").map_or(0, |bytes| bytes.len());
        self.last
    }
}
