//! A scaled count that cannot fail.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MultiplicationInAnInfallibleEntry {
    pub last: i32,
}

#[component]
impl MultiplicationInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, raw: i32, scale: i32) -> i32 {
        self.last = raw.saturating_mul(scale);
        self.last
    }
}
