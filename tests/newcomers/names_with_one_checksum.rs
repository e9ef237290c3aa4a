//! Two names that are one number in the C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct OneChecksum {
    pub name: &'static str,
    pub last: usize,
}

#[component]
impl OneChecksum {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if name == "plumless" || name == "buckeroo" {
            self.last += 1;
        }
        self.last
    }
}
