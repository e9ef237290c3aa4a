#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Not a function.
#[function]
pub struct Gain {
    /// Its value.
    pub value: f64,
}

/// Not data.
#[data]
pub fn twice(x: f64) -> f64 {
    2.0 * x
}

/// An argument too many.
#[function(inline)]
pub fn thrice(x: f64) -> f64 {
    3.0 * x
}

/// It would leave its caller.
#[function(expand)]
pub fn half(x: f64) -> f64 {
    if x < 0.0 {
        return 0.0;
    }
    0.5 * x
}

fn main() {}

/// A call in a body that is rewritten.
#[function(rewrite)]
pub fn fourfold(x: f64) -> f64 {
    doubled(doubled(x))
}

/// Called by it.
#[function]
pub fn doubled(x: f64) -> f64 {
    2.0 * x
}

/// A number says nothing of it.
#[function(2)]
pub fn square(x: f64) -> f64 {
    x * x
}
