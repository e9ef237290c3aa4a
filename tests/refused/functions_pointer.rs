#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Chooses by pointer.
#[function]
pub fn pointer(law: fn(f64) -> f64, x: f64) -> f64 {
    law(x)
}

fn main() {}
