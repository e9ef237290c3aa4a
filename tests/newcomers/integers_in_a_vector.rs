//! A vector of whole numbers.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IntegersInAVector {
    pub last: f64,
}

#[component]
impl IntegersInAVector {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let v = Vector3::new(1, 2, 3);
        self.last = v.norm() * x;
        self.last
    }
}
