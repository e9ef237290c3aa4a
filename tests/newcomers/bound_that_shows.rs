//! A bound above a loop that ends anyway.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BoundThatShows {
    pub values: [f64; 8],
}

#[component]
impl BoundThatShows {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut sum = 0.0;
        #[bound(8)]
        for value in self.values {
            sum += value * x;
        }
        sum
    }
}
