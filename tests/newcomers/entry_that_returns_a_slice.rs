//! A part of the state.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryThatReturnsASlice {
    pub values: [f64; 4],
}

#[component]
impl EntryThatReturnsASlice {
    #[entry]
    pub fn step(&mut self, count: usize) -> &[f64] {
        &self.values[..count]
    }
}
