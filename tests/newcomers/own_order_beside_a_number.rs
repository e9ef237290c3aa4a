//! An order beside numbers, with a `<` of its own.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub struct Level(pub f64);

#[data]
impl PartialEq<f64> for Level {
    fn eq(&self, other: &f64) -> bool {
        self.0 == *other
    }
}

#[data]
impl PartialOrd<f64> for Level {
    fn partial_cmp(&self, other: &f64) -> Option<core::cmp::Ordering> {
        self.0.partial_cmp(other)
    }
    fn lt(&self, other: &f64) -> bool {
        self.0 < *other
    }
}

#[component]
#[derive(Default)]
pub struct OwnOrderBesideANumber {
    pub last: f64,
}

#[component]
impl OwnOrderBesideANumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if Level(x) < 1.0 { 0.0 } else { 1.0 };
        self.last
    }
}
