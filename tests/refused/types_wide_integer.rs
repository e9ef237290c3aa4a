#![no_std]
extern crate std;

use bessemer::prelude::*;

/// 128 bits with a sign.
#[function]
pub fn wide_integer(x: i128) -> i128 {
    x + 1
}

fn main() {}
