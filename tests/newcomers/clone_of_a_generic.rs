//! A copy of a value that need not have one.
use bessemer::prelude::*;

#[function]
fn twice<T: core::ops::Add<Output = T>>(x: T) -> T {
    x + x
}

#[component]
#[derive(Default)]
pub struct GenericClone {
    pub last: f64,
}

#[component]
impl GenericClone {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = twice(x);
        self.last
    }
}
