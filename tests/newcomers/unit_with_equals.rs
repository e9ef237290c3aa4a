//! A speed with its unit.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Motion {
    #[unit = "m/s"]
    pub speed: f64,
}

#[component]
#[derive(Default)]
pub struct UnitWithEquals {
    pub last: f64,
}

#[component]
impl UnitWithEquals {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
