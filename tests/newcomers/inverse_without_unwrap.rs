//! An inverse, as MATLAB has it.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct InverseWithoutUnwrap {
    pub p: Matrix2<f64>,
}

#[component]
impl InverseWithoutUnwrap {
    #[entry]
    pub fn step(&mut self, x: &Vector2<f64>) -> f64 {
        let y = self.p.try_inverse() * x;
        y[0]
    }
}
