//! An index that wraps, by a float.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FloatModulo {
    pub last: f64,
}

#[component]
impl FloatModulo {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let at = x % 3;
        self.last = at;
        self.last
    }
}
