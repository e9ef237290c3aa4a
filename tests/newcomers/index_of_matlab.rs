//! An element as in MATLAB.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IndexOfMatlab {
    pub last: f64,
}

#[component]
impl IndexOfMatlab {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Matrix2::new(x, 0.0, 0.0, 1.0);
        self.last = a[0, 1];
        self.last
    }
}
