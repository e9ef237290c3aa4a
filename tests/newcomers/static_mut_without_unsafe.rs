//! A counter in a global, as C has it.
use bessemer::prelude::*;

static mut TICKS: u32 = 0;

#[component]
#[derive(Default)]
pub struct StaticTicks {
    pub last: u32,
}

#[component]
impl StaticTicks {
    #[entry]
    pub fn step(&mut self) -> u32 {
        TICKS += 1;
        self.last = TICKS;
        self.last
    }
}
