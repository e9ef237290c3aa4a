//! A product of matrices that do not fit.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MisfitMatrix {
    pub last: f64,
}

#[component]
impl MisfitMatrix {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Matrix2x3::<f64>::zeros();
        let b = Matrix2x3::<f64>::zeros();
        self.last = (a * b)[(0, 0)] + x;
        self.last
    }
}
