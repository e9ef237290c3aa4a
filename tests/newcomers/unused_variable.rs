//! A value that is computed and forgotten.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnusedVariable {
    pub last: f64,
}

#[component]
impl UnusedVariable {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let error = 1.0 - x;
        self.last = x;
        self.last
    }
}
