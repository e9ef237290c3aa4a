//! The angle between two vectors.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AngleOfVectors {
    pub last: f64,
}

#[component]
impl AngleOfVectors {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Vector3::new(x, 0.0, 1.0);
        self.last = a.angle(&Vector3::x());
        self.last
    }
}
