//! A value to look at.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Printing {
    pub last: f64,
}

#[component]
impl Printing {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        println!("x = {x}");
        self.last = x;
        self.last
    }
}
