//! A map of two inputs with one axis.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    pub speeds: [f64; 2],
    pub loads: [f64; 2],
    #[axes(speeds)]
    pub rows: [[f64; 2]; 2],
    pub full: [f64; 1],
}

#[component]
#[derive(Default)]
pub struct AxesOfOneForTwo {
    pub last: f64,
}

#[component]
impl AxesOfOneForTwo {
    #[entry]
    pub fn step(&mut self, map: &Map, x: f64) -> f64 {
        self.last = x * map.full[0];
        self.last
    }
}
