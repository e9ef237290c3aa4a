//! A line in the log.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Logging {
    pub last: f64,
}

#[component]
impl Logging {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        log::info!("x = {}", x);
        self.last = x;
        self.last
    }
}
