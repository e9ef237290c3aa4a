//! A law as a field.
use bessemer::prelude::*;

#[interface]
pub trait Law {
    fn respond(&self, x: f64) -> f64;
}

#[component]
#[derive(Default)]
pub struct ImplAsAField {
    pub law: impl Law,
    pub last: f64,
}

#[component]
impl ImplAsAField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
