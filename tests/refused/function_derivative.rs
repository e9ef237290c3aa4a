#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Moves on.
#[function]
pub fn advanced(x: f64) -> f64 {
    2.0 * x
}

/// No function is named.
#[function(derivative)]
pub fn unnamed(x: f64) -> (f64, f64) {
    todo!()
}

/// No parameter is named.
#[function(derivative(advanced))]
pub fn whole(x: f64) -> (f64, f64) {
    todo!()
}

/// A number for a parameter.
#[function(derivative(advanced, 1))]
pub fn numbered(x: f64) -> (f64, f64) {
    todo!()
}

fn main() {}
