//! Three ranges.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ElifOfPython {
    pub last: f64,
}

#[component]
impl ElifOfPython {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x > 1.0 {
            self.last = 1.0;
        } elif x < -1.0 {
            self.last = -1.0;
        } else {
            self.last = x;
        }
        self.last
    }
}
