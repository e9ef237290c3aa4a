//! A field that is read from outside.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct EntryOnAField {
    #[entry]
    pub last: f64,
}

#[component]
impl EntryOnAField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
