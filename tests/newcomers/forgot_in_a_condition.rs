//! A test without an attribute, called in an `if`.
use bessemer::prelude::*;

fn is_fast(x: f64) -> bool {
    x > 10.0
}

#[component]
#[derive(Default)]
pub struct ForgotInACondition {
    pub last: f64,
}

#[component]
impl ForgotInACondition {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if is_fast(x) { 10.0 } else { x };
        self.last
    }
}
