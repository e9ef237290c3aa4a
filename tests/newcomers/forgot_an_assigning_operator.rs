//! An operator `+=` without an attribute.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Charge(pub f64);

impl core::ops::AddAssign<f64> for Charge {
    fn add_assign(&mut self, x: f64) {
        self.0 += x;
    }
}

#[component]
#[derive(Default)]
pub struct ForgotAnAssigningOperator {
    pub last: f64,
}

#[component]
impl ForgotAnAssigningOperator {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut charge = Charge(1.0);
        charge += x;
        self.last = charge.0;
        self.last
    }
}
