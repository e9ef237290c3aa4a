//! An argument that may be missing.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DefaultArgument {
    pub last: f64,
}

#[component]
impl DefaultArgument {
    #[entry]
    pub fn step(&mut self, x: f64, gain: f64 = 1.0) -> f64 {
        self.last = x;
        self.last
    }
}
