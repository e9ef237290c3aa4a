#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Functions that the DSL does not have.
#[function]
pub fn functions(x: f64, y: f64) -> f64 {
    let growth = x.asinh() + f64::atanh(y);
    let angle = x.log(y);
    angle + growth
}

/// Nor these, of integers.
#[function]
pub fn integers(n: u32) -> u32 {
    n.max(n.to_be())
}

fn main() {}
