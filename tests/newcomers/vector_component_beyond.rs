//! The fourth component of three.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FourthComponent {
    pub last: f64,
}

#[component]
impl FourthComponent {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Vector3::new(x, 0.0, 1.0);
        self.last = a.w;
        self.last
    }
}
