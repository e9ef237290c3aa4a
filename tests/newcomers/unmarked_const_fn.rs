//! A constant function that is called with a variable.
use bessemer::prelude::*;

const fn scaled(x: f64) -> f64 {
    x * 2.0
}

#[component]
#[derive(Default)]
pub struct ConstHelper {
    pub last: f64,
}

#[component]
impl ConstHelper {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = scaled(x);
        self.last
    }
}
