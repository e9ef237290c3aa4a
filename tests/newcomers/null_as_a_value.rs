//! No value as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NullAsAValue {
    pub last: f64,
}

#[component]
impl NullAsAValue {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let next = null;
        self.last = if x > 0.0 { next } else { x };
        self.last
    }
}
