//! The magnitude of a raw value.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NegationInAnInfallibleEntry {
    pub last: i32,
}

#[component]
impl NegationInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, raw: i16) -> i32 {
        self.last = i32::from(raw).abs();
        self.last
    }
}
