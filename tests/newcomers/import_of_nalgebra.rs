//! Vectors from nalgebra.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ImportOfNalgebra {
    pub last: f64,
}

#[component]
impl ImportOfNalgebra {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let v = nalgebra::Vector3::new(x, 0.0, 1.0);
        self.last = v.norm();
        self.last
    }
}
