//! A filter with an exchangeable law.
use bessemer::prelude::*;

#[component]
pub struct ClosureKeptInAStruct<F: Fn(f64) -> f64> {
    pub law: F,
}

#[component]
impl<F: Fn(f64) -> f64> ClosureKeptInAStruct<F> {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        (self.law)(x)
    }
}
