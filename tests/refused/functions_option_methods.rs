#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with options what has no place in the C.
#[function]
pub fn options(value: Option<f64>) -> Option<f64> {
    let mut gain = 2.0;
    let scaled = value.map(move |x| {
        gain += 1.0;
        x * gain
    });
    scaled.inspect(|x| assert!(*x > 1.0))
}

fn main() {}
