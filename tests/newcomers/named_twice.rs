//! Two components of the same name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NamedTwice {
    pub last: f64,
}

#[component]
#[derive(Default)]
pub struct NamedTwice {
    pub last: f64,
}

#[component]
impl NamedTwice {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
