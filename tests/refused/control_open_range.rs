#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Without an end.
#[function]
pub fn open_range(x: f64) -> f64 {
    let mut sum = x;
    for i in 0.. {
        sum += i as f64;
    }
    sum
}

fn main() {}
