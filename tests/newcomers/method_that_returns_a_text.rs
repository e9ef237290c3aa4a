//! A mode that shows its name.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub enum Mode {
    Idle,
    Fast,
}

#[data]
impl Mode {
    pub fn name(&self) -> &'static str {
        match self {
            Mode::Idle => "idle",
            Mode::Fast => "fast",
        }
    }
}

#[component]
#[derive(Default)]
pub struct ShownMode {
    pub last: f64,
}

#[component]
impl ShownMode {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
