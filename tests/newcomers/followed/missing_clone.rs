//! A copy before a change.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Snapshot {
    pub p: f64,
}

#[component]
#[derive(Default)]
pub struct MissingClone {
    pub now: Snapshot,
}

#[component]
impl MissingClone {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let before = self.now.clone();
        self.now.p = x;
        before.p
    }
}
