//! A method without its value.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MethodOfTheType {
    pub last: f64,
}

#[component]
impl MethodOfTheType {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Self::doubled(x);
        self.last
    }

    fn doubled(&self, x: f64) -> f64 {
        2.0 * x
    }
}
