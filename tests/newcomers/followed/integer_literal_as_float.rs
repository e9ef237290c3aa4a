//! A literal without its point.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IntegerLiteralAsFloat {
    pub last: f64,
}

#[component]
impl IntegerLiteralAsFloat {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = 2.0 * x;
        self.last
    }
}
