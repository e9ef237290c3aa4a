#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A stage of a chain.
#[interface]
pub trait Stage {
    /// Filters a value.
    fn step(&mut self, x: f64) -> f64;
}

/// A borrowed gain cannot be marked.
#[data]
impl Stage for &f64 {
    fn step(&mut self, x: f64) -> f64 {
        **self * x
    }
}

/// An interface is open: nobody knows the closures that it will be given.
#[interface]
pub trait Each {
    /// Calls the closure.
    fn each(&self, f: impl Fn(f64) -> f64) -> f64;
}

fn main() {}
