//! A helper beside the component.
use bessemer::prelude::*;

fn limit(x: f64) -> f64 {
    if x > 1.0 { 1.0 } else { x }
}

#[component]
#[derive(Default)]
pub struct UnmarkedHelper {
    pub last: f64,
}

#[component]
impl UnmarkedHelper {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = limit(x);
        self.last
    }
}
