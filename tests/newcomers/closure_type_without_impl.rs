//! A helper that takes a law.
use bessemer::prelude::*;

#[function]
fn applied(law: Fn(f64) -> f64, x: f64) -> f64 {
    law(x)
}

#[component]
#[derive(Default)]
pub struct ClosureTypeWithoutImpl {
    pub last: f64,
}

#[component]
impl ClosureTypeWithoutImpl {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = applied(|y| 2.0 * y, x);
        self.last
    }
}
