//! A constant computed from the state.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SelfInAConstant {
    pub gain: f64,
}

#[component]
impl SelfInAConstant {
    const TWICE: f64 = 2.0 * self.gain;

    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        Self::TWICE * x
    }
}
