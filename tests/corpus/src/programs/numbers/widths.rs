//! Every width of integer, each with its own arithmetic.

use bessemer::prelude::*;

/// Products in each width.
#[function]
pub fn products(a: i8, b: i16, c: i32, d: i64) -> i64 {
    let small = i16::from(a) * 3;
    let medium = i32::from(b) * i32::from(small);
    let large = i64::from(c) * i64::from(medium % 1000);
    large.wrapping_add(d)
}

/// Indices are `usize`, 64 bits in the C as in the simulation.
#[function]
pub fn bucket(hash: u64, buckets: usize) -> usize {
    hash as usize % buckets
}
