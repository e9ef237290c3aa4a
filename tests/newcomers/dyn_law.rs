//! A law chosen at run time.
use bessemer::prelude::*;

pub trait AnyLaw {
    fn respond(&self, error: f64) -> f64;
}

#[component]
#[derive(Default)]
pub struct DynLaw {
    pub last: f64,
}

#[component]
impl DynLaw {
    #[entry]
    pub fn step(&mut self, law: &dyn AnyLaw, error: f64) -> f64 {
        self.last = law.respond(error);
        self.last
    }
}
