//! A case.
#![no_std]
use bessemer::prelude::*;

/// A range with links of elements.
#[function]
pub fn sum(values: &[i32; 3], n: i32) -> i32 {
    let mut sum = 0;
    for i in (0..n).skip(1) {
        sum += i;
    }
    for (x, i) in values.iter().zip(0..n) {
        sum += x * i;
    }
    sum + (0..n).enumerate().map(|(_, i)| i).sum::<i32>()
}

/// Ranges without an end.
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
