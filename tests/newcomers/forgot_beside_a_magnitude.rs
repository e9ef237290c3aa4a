//! A helper without an attribute, with functions of numbers.
use bessemer::prelude::*;

fn lean(x: f64) -> f64 {
    x.abs().max(0.5) * 2.0
}

#[component]
#[derive(Default)]
pub struct ForgotBesideAMagnitude {
    pub last: f64,
}

#[component]
impl ForgotBesideAMagnitude {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = lean(x);
        self.last
    }
}
