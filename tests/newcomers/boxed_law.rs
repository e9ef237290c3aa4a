//! A law on the heap, as in Rust's book.
use bessemer::prelude::*;

pub trait HeapLaw {
    fn respond(&self, error: f64) -> f64;
}

#[component]
pub struct BoxedLaw {
    law: Box<dyn HeapLaw>,
}

#[component]
impl BoxedLaw {
    #[entry]
    pub fn step(&mut self, error: f64) -> f64 {
        self.law.respond(error)
    }
}
