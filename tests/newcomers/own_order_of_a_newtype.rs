//! Limits that compare by an own order.
use bessemer::prelude::*;

use core::cmp::Ordering;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub struct Limit(pub f64);

impl PartialOrd for Limit {
    fn partial_cmp(&self, other: &Limit) -> Option<Ordering> {
        other.0.partial_cmp(&self.0)
    }
}

#[component]
#[derive(Default)]
pub struct OwnOrder {
    pub last: f64,
}

#[component]
impl OwnOrder {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let limit = Limit(x);
        self.last = if limit < Limit(2.0) { 1.0 } else { 0.0 };
        self.last
    }
}
