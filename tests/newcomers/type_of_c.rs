//! A type by its name in C.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TypeOfC {
    pub last: f64,
}

#[component]
impl TypeOfC {
    #[entry]
    pub fn step(&mut self, x: double) -> f64 {
        self.last = x;
        self.last
    }
}
