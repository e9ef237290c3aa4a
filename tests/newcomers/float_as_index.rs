//! A table that is read by a float.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatIndex {
    pub last: f64,
}

#[component]
impl FloatIndex {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let table = [1.0, 2.0, 3.0];
        self.last = table[x];
        self.last
    }
}
