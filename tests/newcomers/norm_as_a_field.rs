//! A length.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NormAsAField {
    pub last: f64,
}

#[component]
impl NormAsAField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let r = Vector3::new(x, 0.0, 1.0);
        self.last = r.norm;
        self.last
    }
}
