//! An array from an iterator.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CollectedArray {
    pub last: f64,
}

#[component]
impl CollectedArray {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let doubled: [f64; 3] = [x, 1.0, 2.0].iter().map(|x| 2.0 * x).collect();
        self.last = doubled[0];
        self.last
    }
}
