#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Functions that the DSL does not have.
#[function]
pub fn functions(x: f64, y: f64) -> f64 {
    let growth = x.exp() + f64::ln(y);
    let angle = x.asin() + y.acos();
    let power = x.powi(3) * x.powf(y).round();
    growth + angle.to_degrees() + power.mul_add(x, y) + x.hypot(y)
}

/// Nor these, of integers.
#[function]
pub fn integers(n: u32) -> u32 {
    n.pow(2) + n.saturating_sub(1)
}

fn main() {}
