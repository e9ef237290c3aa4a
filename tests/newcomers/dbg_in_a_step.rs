//! A value to look at, in passing.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Debugging {
    pub last: f64,
}

#[component]
impl Debugging {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = dbg!(2.0 * x);
        self.last
    }
}
