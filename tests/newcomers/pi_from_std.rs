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
        self.last = (x + M_PI) % (2.0 * M_PI);
        self.last
    }
}
