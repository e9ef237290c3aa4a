//! Code behind a `return`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnreachableCode {
    pub last: f64,
}

#[component]
impl UnreachableCode {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        return x;
        self.last = x;
        self.last
    }
}
