//! A rotation by nalgebra's function.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AxisRotation {
    pub last: f64,
}

#[component]
impl AxisRotation {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let r = Rotation3::face_towards(&Vector3::new(x, 0.0, 1.0), &Vector3::y());
        self.last = r[(0, 0)];
        self.last
    }
}
