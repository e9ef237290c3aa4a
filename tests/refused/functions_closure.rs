#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with closures what the C cannot.
#[function]
pub fn closures(x: f64) -> f64 {
    let twice = move |value: f64| 2.0 * value;
    let early = |value: f64| {
        if value < 0.0 {
            return 0.0;
        }
        value
    };
    let half = |value: f64| value / 2.0;
    let other = half;
    twice(x) + early(x) + other(x) + (|value: f64| value)(x)
}

fn main() {}
