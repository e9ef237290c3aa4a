//! A declaration as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DeclarationOfC {
    pub last: f64,
}

#[component]
impl DeclarationOfC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        double y = 2.0 * x;
        self.last = y;
        self.last
    }
}
