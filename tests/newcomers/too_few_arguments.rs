//! A forgotten argument.
use bessemer::prelude::*;

#[function]
fn weighted(x: f64, count: u32) -> f64 {
    x * f64::from(count)
}

#[component]
#[derive(Default)]
pub struct TooFew {
    pub last: f64,
}

#[component]
impl TooFew {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = weighted(x);
        self.last
    }
}
