//! A parameter that shall be saturated.
use bessemer::prelude::*;

#[function]
fn scaled(#[range(0.0..=1.0, saturate)] share: f64) -> f64 {
    2.0 * share
}

#[component]
#[derive(Default)]
pub struct RangeWithAWrongWord {
    pub last: f64,
}

#[component]
impl RangeWithAWrongWord {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = scaled(x);
        self.last
    }
}
