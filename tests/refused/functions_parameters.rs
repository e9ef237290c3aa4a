#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Parameters without a name of their own.
#[function]
pub fn parameters(a: f64, _: f64, ref p: Vector2<f64>) -> f64 {
    a + p.x
}

fn main() {}
