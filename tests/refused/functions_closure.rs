#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with closures what the C cannot.
#[function]
pub fn closures(x: f64) -> f64 {
    let mut gain = 2.0;
    let twice = move |value: f64| gain * value;
    gain = 3.0;
    let mut sum = gain;
    [x].iter().for_each(|value| {
        if *value < 0.0 {
            return;
        }
        sum += value;
    });
    let half = |value: f64| value / 2.0;
    let other = half;
    twice(x) + sum + other(x) + (|value: f64| value)(x)
}

fn main() {}
