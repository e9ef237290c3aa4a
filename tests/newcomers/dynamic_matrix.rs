//! A matrix of any size.
use bessemer::nalgebra::DMatrix;
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DynamicMatrix {
    pub last: f64,
}

#[component]
impl DynamicMatrix {
    #[entry]
    pub fn step(&mut self, n: usize) -> f64 {
        let m = DMatrix::<f64>::identity(n, n);
        self.last = m.trace();
        self.last
    }
}
