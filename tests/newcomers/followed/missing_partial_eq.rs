//! A comparison of modes.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default, PartialEq)]
pub enum Phase {
    #[default]
    Ground,
    Air,
}

#[component]
#[derive(Default)]
pub struct MissingPartialEq {
    pub phase: Phase,
}

#[component]
impl MissingPartialEq {
    #[entry]
    pub fn step(&mut self, lift: bool) -> bool {
        if lift {
            self.phase = Phase::Air;
        }
        self.phase == Phase::Air
    }
}
