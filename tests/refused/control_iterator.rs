#![no_std]
extern crate std;

use bessemer::prelude::*;

/// By iterators.
#[function]
pub fn iterator(samples: &[f64; 4]) -> f64 {
    let mut sum: f64 = samples.iter().chain(samples.iter().step_by(2)).sum();
    for (i, sample) in samples.iter().zip(samples).skip(1).enumerate() {
        sum += sample.0 * i as f64;
    }
    for i in (0..4).rev().step_by(2) {
        sum += samples[i];
    }
    sum
}

fn main() {}
