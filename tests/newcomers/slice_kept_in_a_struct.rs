//! A table that the component looks up.
use bessemer::prelude::*;

#[component]
pub struct SliceKept<'a> {
    pub table: &'a [f64],
}

#[component]
impl<'a> SliceKept<'a> {
    #[entry]
    pub fn step(&mut self, index: usize) -> f64 {
        self.table[index]
    }
}
