//! A limit that is asserted.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AssertionInAnInfallibleEntry {
    pub last: f64,
}

#[component]
impl AssertionInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, x: f64) -> f64 {
        assert!(x >= 0.0);
        self.last = x.sqrt();
        self.last
    }
}
