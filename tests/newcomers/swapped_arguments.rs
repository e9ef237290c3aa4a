//! Numbers in the order of another function.
use bessemer::prelude::*;

#[function]
fn weighted(x: f64, count: u32) -> f64 {
    x * f64::from(count)
}

#[component]
#[derive(Default)]
pub struct SwappedArguments {
    pub last: f64,
}

#[component]
impl SwappedArguments {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = weighted(3, x);
        self.last
    }
}
