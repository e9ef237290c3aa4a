//! A task as it is written for an operating system.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EndlessLoop {
    pub last: f64,
}

#[component]
impl EndlessLoop {
    #[entry]
    pub fn step(&mut self, x: f64) {
        loop {
            self.last += x;
        }
    }
}
