//! A map from states to gains.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MappedGains {
    pub gains: std::collections::BTreeMap<u8, f64>,
    pub last: f64,
}

#[component]
impl MappedGains {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
