#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Panics.
#[function]
pub fn panic(x: f64) -> f64 {
    if x < 0.0 {
        panic!("negative: {x}");
    }
    debug_assert_eq!(x, x);
    todo!()
}

fn main() {}
