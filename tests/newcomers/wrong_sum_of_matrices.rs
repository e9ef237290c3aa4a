//! A sum of two sizes.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WrongSumOfMatrices {
    pub x: Vector3<f64>,
}

#[component]
impl WrongSumOfMatrices {
    #[entry]
    pub fn step(&mut self, y: &Vector2<f64>) -> f64 {
        self.x = self.x + y;
        self.x[0]
    }
}
