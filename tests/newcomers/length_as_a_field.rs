//! The number of elements.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LengthAsAField {
    pub values: [f64; 4],
    pub last: f64,
}

#[component]
impl LengthAsAField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x / self.values.len as f64;
        self.last
    }
}
