//! An `Option` beside a number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct OptionBeside {
    pub last: f64,
}

#[component]
impl OptionBeside {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let values = [x, 1.0];
        let first = values.first();
        self.last = if first > 0.0 { 1.0 } else { 0.0 };
        self.last
    }
}
