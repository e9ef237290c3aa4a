//! A state in a component.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Pair {
    pub a: f64,
}

#[component]
#[derive(Default)]
pub struct FieldWithoutDefault {
    pub pair: Pair,
}

#[component]
impl FieldWithoutDefault {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.pair.a = x;
        self.pair.a
    }
}
