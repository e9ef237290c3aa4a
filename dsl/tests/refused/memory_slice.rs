#![no_std]
extern crate std;

use bessemer::prelude::*;

/// The length is not known.
#[function]
pub fn slice(samples: &[f64], part: &mut [f64]) -> f64 {
    samples[0] + part[1]
}

fn main() {}
