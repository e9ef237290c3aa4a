//! A float where an integer belongs.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WrongTypeOfResult {
    pub last: u16,
}

#[component]
impl WrongTypeOfResult {
    #[entry]
    pub fn step(&mut self, volt: f64) -> u16 {
        self.last = (volt * 4095.0 / 3.3) as u16;
        self.last
    }
}
