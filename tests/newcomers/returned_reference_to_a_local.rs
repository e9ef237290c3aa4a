//! A result by reference.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ReturnedReferenceToALocal {
    pub last: f64,
}

#[component]
impl ReturnedReferenceToALocal {
    #[entry]
    pub fn step(&mut self, x: f64) -> &f64 {
        let y = 2.0 * x;
        self.last = y;
        &y
    }
}
