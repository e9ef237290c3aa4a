//! A state machine as an enum.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub enum Machine {
    #[default]
    Idle,
    Running,
}

#[component]
impl Machine {
    #[entry]
    pub fn step(&mut self) -> bool {
        matches!(self, Machine::Running)
    }
}
