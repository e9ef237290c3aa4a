//! A value of two digits.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct RoundedToDigits {
    pub last: f64,
}

#[component]
impl RoundedToDigits {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.round(2);
        self.last
    }
}
