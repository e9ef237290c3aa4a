//! A callback.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryWithAFunctionPointer {
    pub last: f64,
}

#[component]
impl EntryWithAFunctionPointer {
    #[entry]
    pub fn step(&mut self, law: fn(f64) -> f64, x: f64) -> f64 {
        self.last = law(x);
        self.last
    }
}
