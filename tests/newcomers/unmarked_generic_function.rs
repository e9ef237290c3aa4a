//! A generic helper without attribute.
use bessemer::prelude::*;

fn larger<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

#[component]
#[derive(Default)]
pub struct GenericHelper {
    pub last: f64,
}

#[component]
impl GenericHelper {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = larger(x, self.last);
        self.last
    }
}
