//! A transposed matrix.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TransposeOfNumpy {
    pub last: f64,
}

#[component]
impl TransposeOfNumpy {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Matrix2::new(x, 0.0, 2.0, 1.0);
        self.last = a.T[(0, 1)];
        self.last
    }
}
