//! A constant as state.
use bessemer::prelude::*;

const COUNT: u32 = 0;

#[component]
#[derive(Default)]
pub struct ChangedConstant {
    pub last: f64,
}

#[component]
impl ChangedConstant {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        COUNT += 1;
        self.last = x;
        self.last
    }
}
