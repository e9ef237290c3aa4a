//! The time of the last sample, kept.
use bessemer::prelude::*;
use std::time::Instant;

#[component]
#[derive(Default)]
pub struct InstantField {
    pub last: Option<Instant>,
}

#[component]
impl InstantField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = None;
        x
    }
}
