//! The elements of an array without an attribute.
use bessemer::prelude::*;

#[derive(Clone, Copy, Default)]
pub struct Wheel {
    pub speed: f64,
}

#[component]
#[derive(Default)]
pub struct ForgotAnElement {
    pub wheels: [Wheel; 4],
}

#[component]
impl ForgotAnElement {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.wheels[1].speed = x;
        self.wheels[0].speed
    }
}
