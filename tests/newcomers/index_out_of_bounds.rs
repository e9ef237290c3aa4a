//! The last of four.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IndexOutOfBounds {
    pub last: f64,
}

#[component]
impl IndexOutOfBounds {
    #[entry]
    pub fn step(&mut self, table: &[f64; 4]) -> f64 {
        self.last = table[4];
        self.last
    }
}
