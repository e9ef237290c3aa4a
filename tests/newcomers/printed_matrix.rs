//! A matrix to look at.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct PrintedMatrix {
    pub p: Matrix2<f64>,
}

#[component]
impl PrintedMatrix {
    #[entry]
    pub fn step(&mut self) -> f64 {
        println!("{}", self.p);
        self.p[(0, 0)]
    }
}
