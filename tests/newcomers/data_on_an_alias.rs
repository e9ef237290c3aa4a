//! A name for a number.
use bessemer::prelude::*;

#[data]
pub type Real = f32;

#[component]
#[derive(Default)]
pub struct DataOnAnAlias {
    pub last: f64,
}

#[component]
impl DataOnAnAlias {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
