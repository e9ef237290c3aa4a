//! A loop over floats.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatRange {
    pub last: f64,
}

#[component]
impl FloatRange {
    #[entry]
    pub fn step(&mut self) -> f64 {
        for i in 0..10 {
            self.last += 0.1 * f64::from(i);
        }
        self.last
    }
}
