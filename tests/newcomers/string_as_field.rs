//! The name of a unit.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct StringField {
    pub name: String,
}

#[component]
impl StringField {
    #[entry]
    pub fn step(&mut self) -> usize {
        self.name.len()
    }
}
