//! A list from another crate.
use bessemer::prelude::*;

use heapless::Vec as Short;

#[component]
#[derive(Default)]
pub struct ImportOfAMissingCrate {
    pub last: f64,
}

#[component]
impl ImportOfAMissingCrate {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
