//! A square by an unknown name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SquareFunction {
    pub last: f64,
}

#[component]
impl SquareFunction {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.sqr();
        self.last
    }
}
