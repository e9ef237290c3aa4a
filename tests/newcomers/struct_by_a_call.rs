//! A struct by a call.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct StructByACall {
    pub last: f64,
}

#[component]
impl StructByACall {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let gains = Gains(1.0);
        self.last = gains.p * x;
        self.last
    }
}
