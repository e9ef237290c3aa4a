//! A mode in a component.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default, PartialEq)]
pub enum Stage {
    #[default]
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
