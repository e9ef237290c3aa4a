//! A value held between two limits that are given.
use bessemer::prelude::*;

/// Holds a value between limits.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hold {
    /// The last value.
    pub last: f64,
}

#[component]
impl Hold {
    /// One period.
    #[entry(infallible)]
    pub fn step(&mut self, value: f64, low: f64, high: f64) -> f64 {
        self.last = value.clamp(low, high);
        self.last
    }
}
