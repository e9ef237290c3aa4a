//! A field forgotten in a literal.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Limits {
    pub low: f64,
    pub high: f64,
}

#[component]
#[derive(Default)]
pub struct FieldForgotten {
    pub limits: Limits,
}

#[component]
impl FieldForgotten {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.limits = Limits { high: x };
        self.limits.low
    }
}
