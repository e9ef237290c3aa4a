//! A level in nepers.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LogarithmWithoutBase {
    pub last: f64,
}

#[component]
impl LogarithmWithoutBase {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.log();
        self.last
    }
}
