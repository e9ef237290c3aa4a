//! A counter in a global, as C has it.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct StaticTicks {
    pub ticks: u32,
}

#[component]
impl StaticTicks {
    #[entry]
    pub fn step(&mut self) -> u32 {
        self.ticks += 1;
        self.ticks
    }
}
