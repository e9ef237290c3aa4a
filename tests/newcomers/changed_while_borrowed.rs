//! A reference that is kept too long.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ChangedWhileBorrowed {
    pub values: [f64; 4],
}

#[component]
impl ChangedWhileBorrowed {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let first = &self.values[0];
        self.values[1] = x;
        *first
    }
}
