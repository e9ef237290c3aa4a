//! Two names that are one number in the C, one of them in a table.
use bessemer::prelude::*;

const SPECIES: [&str; 2] = ["minnow", "plumless"];

#[component]
#[derive(Default)]
pub struct TableChecksum {
    pub last: usize,
}

#[component]
impl TableChecksum {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if name == SPECIES[self.last % 2] || name == "buckeroo" {
            self.last = (self.last + 1) % 2;
        }
        self.last
    }
}
