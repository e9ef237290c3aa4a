#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Reads what it must not.
#[function]
pub fn float(bits: u64) -> f64 {
    unsafe { core::mem::transmute(bits) }
}

fn main() {}
