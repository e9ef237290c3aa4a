//! A field that is named alone.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NoSelfField {
    pub last: f64,
}

#[component]
impl NoSelfField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        last = x;
        self.last
    }
}
