//! A variant that does not exist.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Mode {
    Slow,
    Fast,
}

#[component]
#[derive(Default)]
pub struct WrongVariant {
    pub last: f64,
}

#[component]
impl WrongVariant {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mode = Mode::Fastest;
        self.last = if mode == Mode::Fast { x } else { 0.0 };
        self.last
    }
}
