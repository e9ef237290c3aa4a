//! Two pi, by std's name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PiFromStd {
    pub last: f64,
}

#[component]
impl PiFromStd {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = (x + core::f64::consts::PI) % (2.0 * core::f64::consts::PI);
        self.last
    }
}
