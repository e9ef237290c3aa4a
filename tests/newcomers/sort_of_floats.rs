//! A median by `sort`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SortedFloats {
    pub last: f64,
}

#[component]
impl SortedFloats {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut values = [x, self.last, 1.0];
        values.sort_by(|a, b| a.partial_cmp(b));
        self.last = values[1];
        self.last
    }
}
