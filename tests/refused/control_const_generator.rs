#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Computes while compiling, and ignores.
#[function]
pub fn generator(x: f64) -> f64 {
    let limit = const { 1.0 + 1.0 };
    _ = x;
    limit
}

fn main() {}
