#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A part of an array.
#[function]
pub fn part(samples: &[f64; 4]) -> f64 {
    let low = &samples[0..2];
    low[0]
}

fn main() {}
