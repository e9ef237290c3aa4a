//! An element by round brackets.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VectorAsAFunction {
    pub last: f64,
}

#[component]
impl VectorAsAFunction {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let v = Vector3::new(x, 0.0, 1.0);
        self.last = v(0);
        self.last
    }
}
