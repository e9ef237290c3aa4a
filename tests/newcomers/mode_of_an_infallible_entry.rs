//! A mode that the firmware passes to an entry point that cannot report an invalid one.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Course {
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
    pub fn step(&mut self, phase: Course, x: f64) -> f64 {
        self.last = match phase {
            Course::Idle => 0.0,
            Course::Ramp => 0.5 * x,
            Course::Hold => self.last,
        };
        self.last
    }
}
