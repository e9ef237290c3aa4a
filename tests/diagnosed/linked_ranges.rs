//! A case.
#![no_std]
use bessemer::prelude::*;

/// Ranges without an end, of which links ask for one.
#[function]
pub fn open(values: &[u8; 3], n: u8) -> u8 {
    let mut sum = 0;
    for (i, x) in (0..).skip(2).zip(values) {
        sum ^= i ^ x;
    }
    for (i, x) in (0..).step_by(2).zip(values) {
        sum ^= i ^ x;
    }
    for (i, x) in (0..).zip(n..) {
        sum ^= i ^ x;
    }
    sum
}

/// A name for both of a pair.
#[function]
pub fn pairs(values: &[u8; 3]) -> u8 {
    let mut sum = 0;
    for pair in values.iter().enumerate() {
        sum ^= pair.1;
    }
    sum
}
