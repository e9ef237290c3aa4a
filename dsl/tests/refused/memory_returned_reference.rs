#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Gives a reference back.
#[function]
pub fn returned_reference(samples: &[f64; 2]) -> &f64 {
    &samples[0]
}

fn main() {}
