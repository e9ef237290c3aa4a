#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Until it is small.
#[function]
pub fn halved(x: f64) -> f64 {
    let mut rest = x;
    while rest > 1.0 {
        rest /= 2.0;
    }
    rest
}

fn main() {}
