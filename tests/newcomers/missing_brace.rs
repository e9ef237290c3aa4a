//! A brace that is not closed.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MissingBrace {
    pub last: f64,
}

#[component]
impl MissingBrace {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x > 0.0 {
            self.last = x;
        self.last
    }
}
