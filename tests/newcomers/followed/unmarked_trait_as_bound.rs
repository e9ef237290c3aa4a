//! A generic function over a law.
use bessemer::prelude::*;

#[interface]
pub trait Curve {
    fn at(&self, x: f64) -> f64;
}

#[data]
#[derive(Clone, Copy, Default)]
pub struct Straight {
    pub slope: f64,
}

#[data]
impl Curve for Straight {
    fn at(&self, x: f64) -> f64 {
        self.slope * x
    }
}

#[function]
fn twice<C: Curve>(curve: &C, x: f64) -> f64 {
    2.0 * curve.at(x)
}

#[component]
#[derive(Default)]
pub struct UnmarkedBound {
    pub curve: Straight,
}

#[component]
impl UnmarkedBound {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        twice(&self.curve, x)
    }
}
