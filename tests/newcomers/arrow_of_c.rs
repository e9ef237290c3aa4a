//! A field by an arrow.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ArrowOfC {
    pub last: f64,
}

#[component]
impl ArrowOfC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self->last = x;
        self.last
    }
}
