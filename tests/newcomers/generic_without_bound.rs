//! A generic function without a bound.
use bessemer::prelude::*;

#[function]
fn sum<T>(a: T, b: T) -> T {
    a + b
}

#[component]
#[derive(Default)]
pub struct NoBound {
    pub last: f64,
}

#[component]
impl NoBound {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = sum(x, 1.0);
        self.last
    }
}
