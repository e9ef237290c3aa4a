#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Holds a function.
#[function]
pub fn closure(x: f64) -> f64 {
    let twice = |value: f64| 2.0 * value;
    twice(x)
}

fn main() {}
