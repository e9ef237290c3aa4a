//! A value as in C++.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct NewOfCpp {
    pub last: f64,
}

#[component]
impl NewOfCpp {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let gains = new Gains(1.0);
        self.last = gains.p * x;
        self.last
    }
}
