//! A delay line.
use bessemer::prelude::*;
use std::collections::VecDeque;

#[component]
#[derive(Default)]
pub struct DelayLine {
    pub line: VecDeque<f64>,
}

#[component]
impl DelayLine {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.line.push_back(x);
        self.line.pop_front().unwrap_or(0.0)
    }
}
