//! Parameters shared by two loops.
use bessemer::prelude::*;
use std::rc::Rc;

#[component]
pub struct Shared {
    pub gain: Rc<f64>,
}

#[component]
impl Shared {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        *self.gain * x
    }
}
