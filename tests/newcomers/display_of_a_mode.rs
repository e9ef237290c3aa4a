//! A mode that is printed.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default, PartialEq)]
pub enum Mode {
    #[default]
    Slow,
    Fast,
}

#[data]
impl core::fmt::Display for Mode {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("mode")
    }
}

#[component]
#[derive(Default)]
pub struct DisplayOfAMode {
    pub mode: Mode,
    pub last: f64,
}

#[component]
impl DisplayOfAMode {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if self.mode == Mode::Fast { x } else { 0.0 };
        self.last
    }
}
