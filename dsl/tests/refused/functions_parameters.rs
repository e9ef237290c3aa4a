#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Parameters without a name of their own.
#[function]
pub fn parameters((a, b): (f64, f64), _: f64, ref p: Vector2<f64>) -> f64 {
    a + b + p.x
}

fn main() {}
