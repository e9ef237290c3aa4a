//! A value made by a function of an unmarked block.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Line {
    pub slope: f64,
}

impl Line {
    pub fn new(slope: f64) -> Line {
        Line { slope }
    }
}

#[component]
#[derive(Default)]
pub struct MadeByNew {
    pub last: f64,
}

#[component]
impl MadeByNew {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let line = Line::new(2.0);
        self.last = line.slope * x;
        self.last
    }
}
