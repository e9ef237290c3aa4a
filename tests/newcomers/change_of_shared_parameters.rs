//! Gains that are adapted.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct ChangeOfSharedParameters {
    pub last: f64,
}

#[component]
impl ChangeOfSharedParameters {
    #[entry]
    pub fn step(&mut self, gains: &Gains, x: f64) -> f64 {
        gains.p = 0.5 * x;
        self.last = gains.p;
        self.last
    }
}
