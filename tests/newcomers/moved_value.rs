//! A value that is used after it was given away.
use bessemer::prelude::*;

#[data]
#[derive(Default)]
pub struct Load {
    pub mass: f64,
}

#[function]
fn weight(load: Load) -> f64 {
    9.81 * load.mass
}

#[component]
#[derive(Default)]
pub struct MovedValue {
    pub last: f64,
}

#[component]
impl MovedValue {
    #[entry]
    pub fn step(&mut self, mass: f64) -> f64 {
        let load = Load { mass };
        self.last = weight(load);
        self.last + weight(load)
    }
}
