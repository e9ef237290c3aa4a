//! A product of two vectors.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VectorProduct {
    pub last: f64,
}

#[component]
impl VectorProduct {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Vector3::new(x, 0.0, 1.0);
        self.last = a * a;
        self.last
    }
}
