#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with options what has no place in the C.
#[function]
pub fn options(value: Option<f64>) -> Option<f64> {
    let scaled = value.map(move |x| x * 2.0);
    let early = scaled.and_then(|x| {
        if x > 0.0 {
            return None;
        }
        Some(x)
    });
    early.inspect(|x| assert!(*x > 1.0))
}

fn main() {}
