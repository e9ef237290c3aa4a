//! Parameters that are not copied.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Tuning {
    pub p: f64,
}

#[component]
pub struct ReferenceKept<'a> {
    pub tuning: &'a Tuning,
}

#[component]
impl<'a> ReferenceKept<'a> {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.tuning.p * x
    }
}
