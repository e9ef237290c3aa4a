#![no_std]
extern crate std;

use bessemer::prelude::*;

/// 128 bits.
#[function]
pub fn wide_integer(x: u128) -> u128 {
    x + 1_u128
}

fn main() {}
