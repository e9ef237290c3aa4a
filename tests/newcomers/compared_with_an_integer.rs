//! A limit without a point.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ComparedWithAnInteger {
    pub last: f64,
}

#[component]
impl ComparedWithAnInteger {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x > 0 {
            self.last = x;
        }
        self.last
    }
}
