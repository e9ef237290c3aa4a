//! A component with its start values in `new`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WithoutDefault {
    pub gain: f64,
}

#[component]
impl WithoutDefault {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.gain * x
    }
}
