#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with closures what the C cannot.
#[function]
pub fn closures(x: f64) -> f64 {
    let twice = |value: f64| 2.0 * value;
    let mut sum = 3.0;
    [x].iter().for_each(|value| {
        if *value < 0.0 {
            return;
        }
        sum += value;
    });
    let half = |value: f64| value / 2.0;
    let other = half;
    twice(x) + sum + other(x)
}

fn main() {}
