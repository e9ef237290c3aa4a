//! A product as on paper.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NumberBeforeAName {
    pub last: f64,
}

#[component]
impl NumberBeforeAName {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = 2x;
        self.last
    }
}
