//! A mode in a component.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Stage {
    Ground,
    Air,
}

#[component]
#[derive(Default)]
pub struct MissingDefault {
    pub stage: Stage,
}

#[component]
impl MissingDefault {
    #[entry]
    pub fn step(&mut self) -> bool {
        self.stage == Stage::Air
    }
}
