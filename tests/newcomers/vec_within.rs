//! A list that is built in the step.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VecWithin {
    pub last: f64,
}

#[component]
impl VecWithin {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut values = Vec::new();
        values.push(x);
        values.push(2.0 * x);
        self.last = values[0] + values[1];
        self.last
    }
}
