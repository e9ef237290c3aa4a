//! The length of a phasor.
use bessemer::prelude::*;

use bessemer::nalgebra::Complex;

#[component]
#[derive(Default)]
pub struct PhasorLength {
    pub last: f64,
}

#[component]
impl PhasorLength {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Complex::new(x, 1.0).norm();
        self.last
    }
}
