//! Names with a common prefix.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CommonPrefix {
    pub name: &'static str,
    pub last: usize,
}

#[component]
impl CommonPrefix {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if name.starts_with("m_") {
            self.last += 1;
        }
        self.last
    }
}
