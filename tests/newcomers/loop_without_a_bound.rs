//! Newton's method until it has converged.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LoopWithoutABound {
    pub last: f64,
}

#[component]
impl LoopWithoutABound {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut root = x;
        while (root * root - x).abs() > 1e-9 {
            root = 0.5 * (root + x / root);
        }
        self.last = root;
        root
    }
}
