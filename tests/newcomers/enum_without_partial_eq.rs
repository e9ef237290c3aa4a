//! A mode that is compared.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub enum Mode {
    #[default]
    Slow,
    Fast,
}

#[component]
#[derive(Default)]
pub struct ComparedMode {
    pub mode: Mode,
    pub last: f64,
}

#[component]
impl ComparedMode {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if self.mode == Mode::Fast { x } else { 0.0 };
        self.last
    }
}
