//! A component with its parameters set by `new`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Constructed {
    pub gain: f64,
}

impl Constructed {
    /// For the simulation alone.
    pub fn new(gain: f64) -> Self {
        Self { gain }
    }
}

#[component]
impl Constructed {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.gain * x
    }
}
