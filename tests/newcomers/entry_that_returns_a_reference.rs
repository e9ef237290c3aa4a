//! The state, without a copy.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryThatReturnsAReference {
    pub values: [f64; 4],
}

#[component]
impl EntryThatReturnsAReference {
    #[entry]
    pub fn step(&mut self) -> &[f64; 4] {
        &self.values
    }
}
