//! A law without its method.
use bessemer::prelude::*;

#[interface]
pub trait Law {
    fn respond(&self, x: f64) -> f64;
}

#[data]
#[derive(Clone, Copy)]
pub struct Fixed(pub f64);

#[data]
impl Law for Fixed {}

#[component]
#[derive(Default)]
pub struct MissingMethod {
    pub last: f64,
}

#[component]
impl MissingMethod {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Fixed(x).respond(x);
        self.last
    }
}
