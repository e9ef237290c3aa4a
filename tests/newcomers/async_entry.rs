//! A step that waits for the sensor.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AsyncEntry {
    pub last: f64,
}

#[component]
impl AsyncEntry {
    #[entry]
    pub async fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
