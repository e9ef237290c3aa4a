//! Two places of one array at once.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BorrowedTwice {
    pub values: [f64; 4],
}

#[component]
impl BorrowedTwice {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let first = &mut self.values[0];
        let second = &mut self.values[1];
        *first += x;
        *second -= x;
        self.values[0]
    }
}
