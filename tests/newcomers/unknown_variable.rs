//! A misspelt variable.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnknownVariable {
    pub last: f64,
}

#[component]
impl UnknownVariable {
    #[entry]
    pub fn step(&mut self, error: f64) -> f64 {
        self.last = eror;
        self.last
    }
}
