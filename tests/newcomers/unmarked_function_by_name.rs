//! A helper that is passed by its name.
use bessemer::prelude::*;

fn half(x: f64) -> f64 {
    0.5 * x
}

#[component]
#[derive(Default)]
pub struct PassedHelper {
    pub last: f64,
}

#[component]
impl PassedHelper {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let values = [x, 2.0].map(half);
        self.last = values[0];
        self.last
    }
}
