//! A channel that knows its name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NamedChannel {
    pub name: &'static str,
    pub last: f64,
}

#[component]
impl NamedChannel {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
