//! A sign of a type without an attribute.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Torque(pub f64);

impl core::ops::Neg for Torque {
    type Output = Torque;
    fn neg(self) -> Torque {
        Torque(-self.0)
    }
}

#[component]
#[derive(Default)]
pub struct ForgotASign {
    pub last: f64,
}

#[component]
impl ForgotASign {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let torque = -Torque(x);
        self.last = torque.0;
        self.last
    }
}
