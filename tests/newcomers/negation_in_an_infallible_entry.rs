//! The magnitude of a raw value.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NegationInAnInfallibleEntry {
    pub last: i16,
}

#[component]
impl NegationInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, raw: i16) -> i16 {
        self.last = if raw < 0 { -raw } else { raw };
        self.last
    }
}
