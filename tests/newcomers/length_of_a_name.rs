//! A column that is as wide as its name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NamedColumn {
    pub name: &'static str,
    pub last: usize,
}

#[component]
impl NamedColumn {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        self.last = name.len();
        self.last
    }
}
