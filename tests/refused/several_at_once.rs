#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Five things at once, all told.
#[function]
pub fn five(x: f64) -> f64 {
    let name = "x";
    while x > 1.0 {
        println!("{x}");
    }
    let twice = |value: f64| 2.0 * value;
    core::hint::black_box(x)
}

/// The next function has its own.
#[function]
pub fn sixth(x: f64) -> f64 {
    loop {}
}

fn main() {}
