//! A component with its parameters set by `new`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Constructed {
    pub gain: f64,
}

#[component]
impl Constructed {
    pub fn new(gain: f64) -> Self {
        Self { gain }
    }

    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.gain * x
    }
}
