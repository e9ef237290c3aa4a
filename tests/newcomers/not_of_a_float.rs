//! A check whether a value is zero.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NotFloat {
    pub last: f64,
}

#[component]
impl NotFloat {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if !x {
            self.last = 1.0;
        }
        self.last
    }
}
