//! A law behind an interface, as a field.
use bessemer::prelude::*;

#[interface]
pub trait Law {
    fn respond(&self, x: f64) -> f64;
}

#[component]
#[derive(Default)]
pub struct InterfaceField {
    pub law: Law,
    pub last: f64,
}

#[component]
impl InterfaceField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = self.law.respond(x);
        self.last
    }
}
