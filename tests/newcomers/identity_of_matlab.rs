//! An identity by its name in MATLAB.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IdentityOfMatlab {
    pub last: f64,
}

#[component]
impl IdentityOfMatlab {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let a = Matrix3::<f64>::eye();
        self.last = a[(0, 0)] * x;
        self.last
    }
}
