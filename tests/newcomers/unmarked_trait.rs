//! A law that can be exchanged.
use bessemer::prelude::*;

pub trait Law {
    fn respond(&self, error: f64) -> f64;
}

#[data]
#[derive(Clone, Copy, Default)]
pub struct Proportional {
    pub p: f64,
}

#[data]
impl Law for Proportional {
    fn respond(&self, error: f64) -> f64 {
        self.p * error
    }
}

#[component]
#[derive(Default)]
pub struct UnmarkedLaw {
    pub law: Proportional,
}

#[component]
impl UnmarkedLaw {
    #[entry]
    pub fn step(&mut self, error: f64) -> f64 {
        self.law.respond(error)
    }
}
