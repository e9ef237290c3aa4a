//! A state of any size.
use bessemer::prelude::*;
use nalgebra::DVector;

#[component]
pub struct DynamicVectorAsField {
    pub state: DVector<f64>,
}

#[component]
impl DynamicVectorAsField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.state[0] = x;
        self.state.sum()
    }
}
