//! Two elements that are changed at once.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TwoBorrows {
    pub values: [f64; 2],
}

#[component]
impl TwoBorrows {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = &mut self.values[0];
        let b = &mut self.values[1];
        core::mem::swap(a, b);
        self.values[0] + x
    }
}
