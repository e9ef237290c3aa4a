//! Elapsed time from the system's clock.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ElapsedTime {
    pub last: f64,
}

#[component]
impl ElapsedTime {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let now = std::time::Instant::now();
        self.last = x + now.elapsed().as_secs_f64();
        self.last
    }
}
