//! The ticks since the last call.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SubtractionInAnInfallibleEntry {
    pub last: u32,
}

#[component]
impl SubtractionInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, now: u32) -> u32 {
        let elapsed = now - self.last;
        self.last = now;
        elapsed
    }
}
