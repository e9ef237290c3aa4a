//! A number by reference.
use bessemer::prelude::*;

#[function]
fn halved(x: f64) -> f64 {
    0.5 * x
}

#[component]
#[derive(Default)]
pub struct BorrowedForNothing {
    pub last: f64,
}

#[component]
impl BorrowedForNothing {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = halved(&x);
        self.last
    }
}
