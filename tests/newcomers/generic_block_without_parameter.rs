//! A filter of any number.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Lag<T> {
    pub state: T,
}

#[data]
impl Lag {
    pub fn held(&self) -> f64 {
        1.0
    }
}

#[component]
#[derive(Default)]
pub struct GenericBlockWithoutParameter {
    pub last: f64,
    pub lag: Lag<f64>,
}

#[component]
impl GenericBlockWithoutParameter {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
