//! A sine, as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SineAsFunction {
    pub last: f64,
}

#[component]
impl SineAsFunction {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = sin(x);
        self.last
    }
}
