//! A generic helper that takes a law.
use bessemer::prelude::*;

#[function]
fn applied<F>(law: F, x: f64) -> f64 {
    law(x)
}

#[component]
#[derive(Default)]
pub struct ClosureWithoutABound {
    pub last: f64,
}

#[component]
impl ClosureWithoutABound {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = applied(|y| 2.0 * y, x);
        self.last
    }
}
