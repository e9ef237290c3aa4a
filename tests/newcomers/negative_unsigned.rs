//! A mark for no value.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NegativeUnsigned {
    pub last: f64,
}

#[component]
impl NegativeUnsigned {
    #[entry]
    pub fn step(&mut self, n: u32) -> f64 {
        let none: u32 = -1;
        self.last = if n == none { 0.0 } else { 1.0 };
        self.last
    }
}
