//! A table by a signed index.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IndexByASignedNumber {
    pub last: f64,
}

#[component]
impl IndexByASignedNumber {
    #[entry]
    pub fn step(&mut self, i: i32) -> f64 {
        self.last = [1.0, 2.0, 3.0][i];
        self.last
    }
}
