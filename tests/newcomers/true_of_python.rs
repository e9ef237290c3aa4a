//! A flag as in Python.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TrueOfPython {
    pub last: f64,
}

#[component]
impl TrueOfPython {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let on = True;
        if on {
            self.last = x;
        }
        self.last
    }
}
