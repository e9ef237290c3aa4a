//! A misspelt attribute of a method.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MisspeltEntry {
    pub last: f64,
}

#[component]
impl MisspeltEntry {
    #[entri]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
