//! A forgotten semicolon.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MissingSemicolon {
    pub last: f64,
}

#[component]
impl MissingSemicolon {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x
        self.last
    }
}
