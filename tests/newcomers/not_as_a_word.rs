//! A negation by a word.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NotAsAWord {
    pub last: f64,
}

#[component]
impl NotAsAWord {
    #[entry]
    pub fn step(&mut self, x: f64, on: bool) -> f64 {
        if not on {
            self.last = x;
        }
        self.last
    }
}
