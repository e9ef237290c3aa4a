#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Asserts in some builds.
#[function]
pub fn same(x: f64) -> f64 {
    debug_assert_eq!(x, x);
    x
}

fn main() {}
