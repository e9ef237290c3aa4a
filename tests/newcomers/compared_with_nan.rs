//! A check of a sensor by its value.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ComparedWithNan {
    pub last: f64,
}

#[component]
impl ComparedWithNan {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x == f64::NAN {
            return self.last;
        }
        self.last = x;
        self.last
    }
}
