//! A field as in C++.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ThisOfCpp {
    pub last: f64,
}

#[component]
impl ThisOfCpp {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        this.last = x;
        self.last
    }
}
