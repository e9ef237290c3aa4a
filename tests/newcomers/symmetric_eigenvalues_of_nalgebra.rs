//! Eigenvalues by nalgebra's method.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NalgebraEigen {
    pub last: f64,
}

#[component]
impl NalgebraEigen {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Matrix2::new(x, 0.0, 0.0, 1.0);
        self.last = a.symmetric_eigenvalues()[0];
        self.last
    }
}
