//! A name with the number of the empty one in the C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NoChecksum {
    pub last: usize,
}

#[component]
impl NoChecksum {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if name == "AAAAaaAAAAaaAaAAaaaAaAAAaaAaaaAa" {
            self.last += 1;
        }
        self.last
    }
}
