//! A helper over any number of elements.
use bessemer::prelude::*;

#[function]
fn total(values: [f64]) -> f64 {
    values[0] + values[1]
}

#[component]
#[derive(Default)]
pub struct SliceWithoutReference {
    pub last: f64,
}

#[component]
impl SliceWithoutReference {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = total(&[x, 1.0]);
        self.last
    }
}
