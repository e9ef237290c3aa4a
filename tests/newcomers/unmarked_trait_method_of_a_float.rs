//! An extension trait for floats.
use bessemer::prelude::*;

pub trait Squared {
    fn squared(self) -> Self;
}

impl Squared for f64 {
    fn squared(self) -> f64 {
        self * self
    }
}

#[component]
#[derive(Default)]
pub struct ExtendedFloat {
    pub last: f64,
}

#[component]
impl ExtendedFloat {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.squared();
        self.last
    }
}
