//! A counter behind its loop.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CounterBehind {
    pub last: f64,
}

#[component]
impl CounterBehind {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        for i in 0..3 {
            self.last += x;
        }
        self.last * f64::from(i)
    }
}
