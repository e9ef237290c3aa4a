//! A value that is there, the author knows.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnwrapInAnInfallibleEntry {
    pub last: f64,
}

#[component]
impl UnwrapInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, value: Option<f64>) -> f64 {
        self.last = value.unwrap();
        self.last
    }
}
