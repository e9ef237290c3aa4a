//! A newtype that compares with a number.
use bessemer::prelude::*;

use core::cmp::Ordering;

#[data]
#[derive(Clone, Copy)]
pub struct Hertz(pub f64);

#[data]
impl PartialEq<f64> for Hertz {
    fn eq(&self, other: &f64) -> bool {
        self.0 == *other
    }
}

#[data]
impl PartialOrd<f64> for Hertz {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        self.0.partial_cmp(other)
    }
}

#[component]
#[derive(Default)]
pub struct BesideNumber {
    pub last: f64,
}

#[component]
impl BesideNumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if Hertz(x) > 50.0 { 1.0 } else { 0.0 };
        self.last
    }
}
