//! A mode that is switched.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Mode {
    Idle,
    Run,
}

#[component]
#[derive(Default)]
pub struct UnmarkedMode {
    pub last: f64,
}

#[component]
impl UnmarkedMode {
    #[entry]
    pub fn step(&mut self, mode: Mode, x: f64) -> f64 {
        self.last = if mode == Mode::Run { x } else { 0.0 };
        self.last
    }
}
