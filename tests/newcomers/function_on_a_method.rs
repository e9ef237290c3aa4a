//! The attribute of functions on a method.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Scale {
    pub p: f64,
}

impl Scale {
    #[function]
    pub fn at(&self, x: f64) -> f64 {
        self.p * x
    }
}

#[component]
#[derive(Default)]
pub struct FunctionOnMethod {
    pub scale: Scale,
}

#[component]
impl FunctionOnMethod {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.scale.at(x)
    }
}
