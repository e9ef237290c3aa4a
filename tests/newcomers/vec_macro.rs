//! A list by the macro.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct VecMacro {
    pub last: f64,
}

#[component]
impl VecMacro {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let values = vec![x; 3];
        self.last = values[2];
        self.last
    }
}
