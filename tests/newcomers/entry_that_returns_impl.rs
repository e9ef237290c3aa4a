//! An iterator over the state.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryThatReturnsImpl {
    pub values: [f64; 4],
}

#[component]
impl EntryThatReturnsImpl {
    #[entry]
    pub fn step(&self) -> impl Iterator<Item = f64> {
        self.values.into_iter()
    }
}
