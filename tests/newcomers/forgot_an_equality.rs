//! An own `==` without an attribute.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Angle(pub f64);

impl PartialEq for Angle {
    fn eq(&self, other: &Angle) -> bool {
        (self.0 - other.0).abs() < 1e-6
    }
}

#[component]
#[derive(Default)]
pub struct ForgotAnEquality {
    pub last: f64,
}

#[component]
impl ForgotAnEquality {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if Angle(x) == Angle(1.0) { 1.0 } else { 0.0 };
        self.last
    }
}
