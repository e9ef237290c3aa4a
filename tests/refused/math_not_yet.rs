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

fn main() {}
