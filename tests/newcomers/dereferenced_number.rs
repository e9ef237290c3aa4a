//! A pointer as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DereferencedNumber {
    pub last: f64,
}

#[component]
impl DereferencedNumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = *x;
        self.last
    }
}
