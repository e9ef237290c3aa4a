//! A sum of a number and a matrix, as MATLAB takes it.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ScalarPlusMatrix {
    pub p: Matrix2<f64>,
}

#[component]
impl ScalarPlusMatrix {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.p = self.p.add_scalar(x);
        self.p[(0, 0)]
    }
}
