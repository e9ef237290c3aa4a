//! A choice by number.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SwitchOfC {
    pub last: f64,
}

#[component]
impl SwitchOfC {
    #[entry]
    pub fn step(&mut self, n: u8) -> f64 {
        switch n {
            0 => self.last = 0.0,
            _ => self.last = 1.0,
        }
        self.last
    }
}
