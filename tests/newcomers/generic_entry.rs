//! One step for each float.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct GenericEntry {
    pub last: f64,
}

#[component]
impl GenericEntry {
    #[entry]
    pub fn step<T: Real>(&mut self, x: T) -> T {
        x + x
    }
}
