#![no_std]
extern crate std;

use bessemer::prelude::*;

/// On something else.
#[interface]
pub struct Not {
    /// A field.
    pub x: f64,
}

/// With a default that is refused.
#[interface]
pub trait Taken {
    /// Loops for ever.
    fn run(&self) -> f64 {
        loop {}
    }
}

/// Without the attribute.
pub trait Unmarked {
    /// One period.
    fn step(&mut self) -> f64;
}

/// A controller.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    level: f64,
}

#[component]
impl Unmarked for Controller {
    fn step(&mut self) -> f64 {
        self.level
    }
}

fn main() {}
