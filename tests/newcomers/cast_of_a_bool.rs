//! A flag as a number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CastOfABool {
    pub last: f64,
}

#[component]
impl CastOfABool {
    #[entry]
    pub fn step(&mut self, on: bool) -> f64 {
        self.last = on as f64;
        self.last
    }
}
