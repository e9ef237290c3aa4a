//! A cleared buffer.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ClearedBuffer {
    pub last: f64,
}

#[component]
impl ClearedBuffer {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let samples: [f64; 40] = Default::default();
        self.last = samples[3] + x;
        self.last
    }
}
