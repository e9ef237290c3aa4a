#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Through a raw pointer.
#[function]
pub fn raw_pointer(x: f64, out: *mut f64) -> f64 {
    let place = &raw const x;
    *out
}

fn main() {}
