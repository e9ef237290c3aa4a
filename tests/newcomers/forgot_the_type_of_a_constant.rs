//! A constant whose type has no attribute.
use bessemer::prelude::*;

#[derive(Clone, Copy)]
pub struct Window {
    pub low: f64,
    pub high: f64,
}

const LIMITS: Window = Window { low: -1.0, high: 1.0 };

#[component]
#[derive(Default)]
pub struct ForgotTheTypeOfAConstant {
    pub last: f64,
}

#[component]
impl ForgotTheTypeOfAConstant {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if x > LIMITS.high { LIMITS.high } else { x };
        self.last
    }
}
