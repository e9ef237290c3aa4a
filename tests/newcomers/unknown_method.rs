//! A method that floats do not have.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnknownMethod {
    pub last: f64,
}

#[component]
impl UnknownMethod {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.limit(1.0);
        self.last
    }
}
