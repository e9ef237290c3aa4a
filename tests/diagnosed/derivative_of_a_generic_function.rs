//! A generic function has no derivative of its own.
#![no_std]
use bessemer::prelude::*;

#[function]
pub fn twice<T: Real>(x: T) -> T {
    x + x
}

#[function(derivative(twice, x))]
pub fn twice_slope(x: f64) -> (f64, f64) {
    todo!()
}
