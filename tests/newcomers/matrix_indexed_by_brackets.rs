//! An element, as in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MatrixIndexedByBrackets {
    pub p: Matrix2<f64>,
}

#[component]
impl MatrixIndexedByBrackets {
    #[entry]
    pub fn step(&mut self) -> f64 {
        self.p[0][1]
    }
}
