//! A torque.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CrossWithoutReference {
    pub last: f64,
}

#[component]
impl CrossWithoutReference {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let r = Vector3::new(x, 0.0, 1.0);
        let f = Vector3::new(0.0, x, 1.0);
        self.last = r.cross(f).x;
        self.last
    }
}
