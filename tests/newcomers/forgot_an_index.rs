//! An index of a type without an attribute.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Axes {
    pub all: [f64; 3],
}

impl core::ops::Index<usize> for Axes {
    type Output = f64;
    fn index(&self, at: usize) -> &f64 {
        &self.all[at]
    }
}

#[component]
#[derive(Default)]
pub struct ForgotAnIndex {
    pub last: f64,
}

#[component]
impl ForgotAnIndex {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let axes = Axes { all: [x, x, x] };
        self.last = axes[1];
        self.last
    }
}
