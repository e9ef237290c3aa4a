//! The area of a circle.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PiWithoutImport {
    pub last: f64,
}

#[component]
impl PiWithoutImport {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = PI * x * x;
        self.last
    }
}
