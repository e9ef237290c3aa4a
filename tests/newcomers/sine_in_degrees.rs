//! A sine by an unknown name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct DegreeSine {
    pub last: f64,
}

#[component]
impl DegreeSine {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x.sind();
        self.last
    }
}
