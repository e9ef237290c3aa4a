//! Two blocks of a type, of which the second has no attribute.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Curve {
    pub slope: f64,
}

#[data]
impl Curve {
    pub fn at(&self, x: f64) -> f64 {
        self.slope * x
    }
}

impl Curve {
    pub fn twice(&self, x: f64) -> f64 {
        2.0 * self.slope * x
    }
}

#[component]
#[derive(Default)]
pub struct ForgotTheSecondBlock {
    pub last: f64,
}

#[component]
impl ForgotTheSecondBlock {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let curve = Curve { slope: 2.0 };
        self.last = curve.at(x) + curve.twice(x);
        self.last
    }
}
