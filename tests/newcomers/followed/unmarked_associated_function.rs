//! A constructor of gains, called in the entry.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Slopes {
    pub p: f64,
}

#[data]
impl Slopes {
    pub fn steep() -> Slopes {
        Slopes { p: 9.0 }
    }
}

#[component]
#[derive(Default)]
pub struct UnmarkedConstructor {
    pub last: f64,
}

#[component]
impl UnmarkedConstructor {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Slopes::steep().p * x;
        self.last
    }
}
