#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A pair.
#[function]
pub fn tuple(x: f64) -> (f64, f64) {
    let pair = (x, 2.0 * x);
    let (a, b) = pair;
    (pair.0 + a, pair.1 + b)
}

fn main() {}
