//! A field taken out of the component.
use bessemer::prelude::*;

#[data]
#[derive(Default)]
pub struct Ballast {
    pub mass: f64,
}

#[component]
#[derive(Default)]
pub struct MovedOutOfSelf {
    pub load: Ballast,
}

#[component]
impl MovedOutOfSelf {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let load = self.load;
        load.mass * x
    }
}
