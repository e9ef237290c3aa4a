//! An error passed on from a step that gives a number.
use bessemer::prelude::*;

#[function]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x) } else { None }
}

#[component]
#[derive(Default)]
pub struct QuestionMarkWithoutAResult {
    pub last: f64,
}

#[component]
impl QuestionMarkWithoutAResult {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = positive(x).unwrap_or(0.0);
        self.last
    }
}
