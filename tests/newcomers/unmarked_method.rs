//! A method of a marked struct.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Line {
    pub slope: f64,
}

impl Line {
    pub fn at(&self, x: f64) -> f64 {
        self.slope * x
    }
}

#[component]
#[derive(Default)]
pub struct UnmarkedMethod {
    pub last: f64,
}

#[component]
impl UnmarkedMethod {
    #[entry]
    pub fn step(&mut self, line: &Line, x: f64) -> f64 {
        self.last = line.at(x);
        self.last
    }
}
