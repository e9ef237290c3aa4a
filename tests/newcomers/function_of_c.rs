//! The magnitude by its function in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FunctionOfC {
    pub last: f64,
}

#[component]
impl FunctionOfC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = fabs(x);
        self.last
    }
}
