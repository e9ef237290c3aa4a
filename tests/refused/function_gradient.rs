#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A cost.
#[function]
pub fn cost(x: f64) -> f64 {
    x * x
}

/// No function is named.
#[function(gradient)]
pub fn unnamed(x: f64) -> (f64, f64) {
    todo!()
}

/// No parameter is named.
#[function(gradient(cost))]
pub fn whole(x: f64) -> (f64, f64) {
    todo!()
}

fn main() {}
