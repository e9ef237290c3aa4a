//! A constant with an attribute.
use bessemer::prelude::*;

#[function]
const GAIN: f64 = 2.0;

#[component]
#[derive(Default)]
pub struct FunctionOnAConstant {
    pub last: f64,
}

#[component]
impl FunctionOnAConstant {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
