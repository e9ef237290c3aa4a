//! A controller from the library.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BlockOfAnotherCrate {
    pub pid: Pid,
    pub last: f64,
}

#[component]
impl BlockOfAnotherCrate {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = self.pid.step(x);
        self.last
    }
}
