//! A task beside.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SpawnedThread {
    pub last: f64,
}

#[component]
impl SpawnedThread {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        std::thread::spawn(move || 2.0 * x);
        self.last = x;
        self.last
    }
}
