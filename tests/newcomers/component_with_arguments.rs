//! A name in the attribute.
use bessemer::prelude::*;

#[component(name = "pid")]
#[derive(Default)]
pub struct Arguments {
    pub last: f64,
}

#[component]
impl Arguments {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
