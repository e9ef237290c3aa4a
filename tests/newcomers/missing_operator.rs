//! A sum of two structs.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Offset {
    pub x: f64,
}

#[component]
#[derive(Default)]
pub struct MissingOperator {
    pub sum: Offset,
}

#[component]
impl MissingOperator {
    #[entry]
    pub fn step(&mut self, x: &Offset) -> f64 {
        self.sum = self.sum + *x;
        self.sum.x
    }
}
