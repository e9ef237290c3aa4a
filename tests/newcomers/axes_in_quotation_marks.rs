//! A map that names its axis as a text.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    pub speeds: [f64; 4],
    #[axes("speeds")]
    pub full: [f64; 4],
}

#[component]
#[derive(Default)]
pub struct AxesInQuotationMarks {
    pub last: f64,
}

#[component]
impl AxesInQuotationMarks {
    #[entry]
    pub fn step(&mut self, map: &Map, x: f64) -> f64 {
        self.last = x * map.full[0];
        self.last
    }
}
