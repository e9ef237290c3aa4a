//! A misspelt field.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnknownField {
    pub last: f64,
}

#[component]
impl UnknownField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.lst = x;
        self.last
    }
}
