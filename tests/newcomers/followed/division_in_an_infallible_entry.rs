//! A mean that cannot fail.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DivisionInAnInfallibleEntry {
    pub last: u32,
}

#[component]
impl DivisionInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, sum: u32, count: u32) -> u32 {
        self.last = if count != 0 { sum / count } else { 0 };
        self.last
    }
}
