//! A mode that the firmware passes to an entry point that cannot report an invalid one.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Phase {
    Idle,
    Ramp,
    Hold,
}

#[component]
#[derive(Default)]
pub struct UncheckedMode {
    pub last: f64,
}

#[component]
impl UncheckedMode {
    #[entry(infallible)]
    pub fn step(&mut self, phase: Phase, x: f64) -> f64 {
        self.last = match phase {
            Phase::Idle => 0.0,
            Phase::Ramp => 0.5 * x,
            Phase::Hold => self.last,
        };
        self.last
    }
}
