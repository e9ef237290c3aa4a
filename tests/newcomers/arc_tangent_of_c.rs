//! An angle by the function of C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ArcTangentOfC {
    pub last: f64,
}

#[component]
impl ArcTangentOfC {
    #[entry]
    pub fn step(&mut self, x: f64, y: f64) -> f64 {
        self.last = atan2(y, x);
        self.last
    }
}
