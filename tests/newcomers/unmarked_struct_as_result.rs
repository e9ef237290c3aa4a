//! Two results at once.
use bessemer::prelude::*;

pub struct Command {
    pub left: f64,
    pub right: f64,
}

#[component]
#[derive(Default)]
pub struct UnmarkedResult {
    pub last: f64,
}

#[component]
impl UnmarkedResult {
    #[entry]
    pub fn step(&mut self, turn: f64) -> Command {
        self.last = turn;
        Command { left: turn, right: -turn }
    }
}
