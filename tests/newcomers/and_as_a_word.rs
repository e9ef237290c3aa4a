//! Conditions that are joined by words.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AndWord {
    pub last: f64,
}

#[component]
impl AndWord {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x > 1.0 and x < 2.0 {
            self.last = 1.0;
        }
        self.last
    }
}
