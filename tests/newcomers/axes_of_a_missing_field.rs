//! A map whose axis is misspelt.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    pub speeds: [f64; 4],
    #[axes(speed)]
    pub full: [f64; 4],
}

#[component]
#[derive(Default)]
pub struct AxesOfAMissingField {
    pub last: f64,
}

#[component]
impl AxesOfAMissingField {
    #[entry]
    pub fn step(&mut self, map: &Map, x: f64) -> f64 {
        self.last = x * map.full[0];
        self.last
    }
}
