//! Channels in the order of their names.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SortedNames {
    pub name: &'static str,
    pub last: usize,
}

#[component]
impl SortedNames {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if name < self.name {
            self.name = name;
        }
        self.last
    }
}
