//! A map with an axis of another length.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    pub speeds: [f64; 3],
    #[axes(speeds)]
    pub full: [f64; 4],
}

#[component]
#[derive(Default)]
pub struct AxesOfAnotherLength {
    pub last: f64,
}

#[component]
impl AxesOfAnotherLength {
    #[entry]
    pub fn step(&mut self, map: &Map, x: f64) -> f64 {
        self.last = x * map.full[0];
        self.last
    }
}
