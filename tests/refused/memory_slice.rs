#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A slice that is held.
#[data]
pub struct Held<'a> {
    samples: &'a [f64],
}

/// A slice that is given back.
#[function]
pub fn rest(samples: &[f64]) -> &[f64] {
    &samples[1..]
}

fn main() {}
