//! A loop whose bound is left out.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BoundWithoutANumber {
    pub last: f64,
}

#[component]
impl BoundWithoutANumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut y = x;
        #[bound]
        while y > 1.0 {
            y *= 0.5;
        }
        self.last = y;
        self.last
    }
}
