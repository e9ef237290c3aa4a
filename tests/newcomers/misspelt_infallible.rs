//! A misspelt argument.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MisspeltInfallible {
    pub last: f64,
}

#[component]
impl MisspeltInfallible {
    #[entry(infalible)]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
