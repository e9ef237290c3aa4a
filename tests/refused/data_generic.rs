#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Holds a reference.
#[data]
pub struct Borrowed<'a, T> {
    /// To what.
    pub value: &'a T,
}

/// A filter.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filter<T> {
    level: T,
}

#[component]
impl<T: Real> Filter<T> {
    /// One entry point.
    #[entry]
    pub fn step(&mut self, x: T) -> T {
        self.level += x;
        self.level
    }
}

/// A name with a parameter of its own.
#[component]
pub type Filters<T> = Filter<T>;

/// Rust's own literals have a type.
#[function]
pub fn half<T: Real>(x: T) -> T {
    x * 0.5
}

fn main() {}
