//! A method that forgets what it returns.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NoReturnType {
    pub last: f64,
}

#[component]
impl NoReturnType {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = self.doubled(x);
        self.last
    }

    fn doubled(&self, x: f64) {
        2.0 * x
    }
}
