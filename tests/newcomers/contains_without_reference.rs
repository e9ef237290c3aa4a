//! A search for a known code.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ContainsWithoutReference {
    pub last: f64,
}

#[component]
impl ContainsWithoutReference {
    #[entry]
    pub fn step(&mut self, code: u8) -> f64 {
        self.last = if [1, 2, 5].contains(code) { 1.0 } else { 0.0 };
        self.last
    }
}
