//! A block with a semicolon too many.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnitLet {
    pub last: f64,
}

#[component]
impl UnitLet {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let y = {
            x * 2.0;
        };
        self.last = y;
        self.last
    }
}
