//! Two variables in a line.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TwoNamesInALet {
    pub last: f64,
}

#[component]
impl TwoNamesInALet {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = x, b = 2.0;
        self.last = a * b;
        self.last
    }
}
