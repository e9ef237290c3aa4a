//! A sum of two widths.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ImplicitWidening {
    pub last: u32,
}

#[component]
impl ImplicitWidening {
    #[entry]
    pub fn step(&mut self, a: u16, b: u32) -> u32 {
        self.last = u32::from(a) + b;
        self.last
    }
}
