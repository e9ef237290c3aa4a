//! A loop with a bound of the caller.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BoundByAVariable {
    pub last: f64,
}

#[component]
impl BoundByAVariable {
    #[entry]
    pub fn step(&mut self, x: f64, n: u32) -> f64 {
        let mut y = x;
        #[bound(n)]
        while y > 1.0 {
            y *= 0.5;
        }
        self.last = y;
        self.last
    }
}
