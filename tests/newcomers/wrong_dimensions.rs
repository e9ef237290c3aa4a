//! A gain matrix the wrong way round.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WrongDimensions {
    pub x: Vector3<f64>,
}

#[component]
impl WrongDimensions {
    #[entry]
    pub fn step(&mut self, k: &Matrix2x3<f64>, y: &Vector2<f64>) -> f64 {
        self.x += k * y;
        self.x[0]
    }
}
