//! A check of a sensor.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NanByItsNameInC {
    pub last: f64,
}

#[component]
impl NanByItsNameInC {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x.isnan() {
            return self.last;
        }
        self.last = x;
        self.last
    }
}
