//! A generic gain by an unmarked trait.
use bessemer::prelude::*;

pub trait Apply {
    fn apply(&self, x: f64) -> f64;
}

#[data]
#[derive(Clone, Copy)]
pub struct Gain(pub f64);

impl Apply for Gain {
    fn apply(&self, x: f64) -> f64 {
        self.0 * x
    }
}

#[function]
fn applied<A: Apply>(law: &A, x: f64) -> f64 {
    law.apply(x)
}

#[component]
#[derive(Default)]
pub struct UnmarkedBound {
    pub last: f64,
}

#[component]
impl UnmarkedBound {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = applied(&Gain(x), x);
        self.last
    }
}
