#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Two views of the same bytes.
#[data]
pub union Bits {
    value: f64,
    bits: u64,
}

fn main() {}
