//! An own order of one type.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub struct Rank(pub f64);

#[data]
impl PartialOrd<Rank> for Rank {
    fn partial_cmp(&self, other: &Rank) -> Option<core::cmp::Ordering> {
        other.0.partial_cmp(&self.0)
    }
}

#[component]
#[derive(Default)]
pub struct OwnMarkedOrder {
    pub last: f64,
}

#[component]
impl OwnMarkedOrder {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = if Rank(x) < Rank(1.0) { 0.0 } else { 1.0 };
        self.last
    }
}
