//! A part of an option.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IfSomeWithoutLet {
    pub last: f64,
}

#[component]
impl IfSomeWithoutLet {
    #[entry]
    pub fn step(&mut self, x: f64, limit: Option<f64>) -> f64 {
        if Some(y) = limit {
            self.last = y.min(x);
        }
        self.last
    }
}
