//! A counter that cannot fail.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct OverflowInAnInfallibleEntry {
    pub count: u32,
}

#[component]
impl OverflowInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self) -> u32 {
        self.count += 1;
        self.count
    }
}
