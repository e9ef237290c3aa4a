#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A component.
#[component]
#[derive(Default)]
pub struct Height {
    /// The integral of the error, m·s.
    pub integral: f64,
}

#[component]
impl Height {
    /// An argument that means nothing.
    #[entry(fast)]
    pub fn step(&mut self, error: f64) -> f64 {
        self.integral += error;
        self.integral
    }

    /// A receiver that C has no word for.
    pub fn boxed(self: &mut Self) {}
}

/// Outside of a component.
#[entry]
pub fn step(x: f64) -> f64 {
    x
}

/// Plain data.
#[data]
pub struct Gain {
    /// Its value.
    pub value: f64,
}

#[data]
impl Gain {
    /// Not called by firmware.
    #[entry]
    pub fn respond(&self, x: f64) -> f64 {
        self.value * x
    }
}

/// Not a struct.
#[component]
#[derive(Clone, Copy)]
pub enum Mode {
    /// Off.
    Idle,
}

fn main() {}
