//! A value of an `if` alone.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IfWithoutElse {
    pub last: f64,
}

#[component]
impl IfWithoutElse {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if x > 0.0 { x };
        self.last
    }
}
