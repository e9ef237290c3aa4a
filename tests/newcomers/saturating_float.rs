//! A saturated sum of floats.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SaturatingFloat {
    pub last: f64,
}

#[component]
impl SaturatingFloat {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = self.last.saturating_add(x);
        self.last
    }
}
