//! A struct with `=`.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct ColonAndEquals {
    pub last: f64,
}

#[component]
impl ColonAndEquals {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let gains = Gains { p = 1.0 };
        self.last = gains.p * x;
        self.last
    }
}
