//! A field for debugging only.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Conditional {
    pub last: f64,
    #[cfg(debug_assertions)]
    pub trace: f64,
}

#[component]
impl Conditional {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
