//! A literal in a generic function.
use bessemer::prelude::*;

#[function]
fn half<T: Real>(x: T) -> T {
    x * 0.5
}

#[component]
#[derive(Default)]
pub struct GenericLiteral {
    pub last: f64,
}

#[component]
impl GenericLiteral {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = half(x);
        self.last
    }
}
