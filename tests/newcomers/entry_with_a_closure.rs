//! A law handed to the step.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryWithAClosure {
    pub last: f64,
}

#[component]
impl EntryWithAClosure {
    #[entry]
    pub fn step(&mut self, law: impl Fn(f64) -> f64, x: f64) -> f64 {
        self.last = law(x);
        self.last
    }
}
