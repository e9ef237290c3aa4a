//! Ranges without an end of which it does not show how often they are asked.
#![no_std]
use bessemer::prelude::*;

/// The range first, in a chain.
#[function]
pub fn chained(values: &[u8; 3], n: u8) -> u8 {
    (n..).zip(values).fold(0, |a, (i, x)| a ^ i ^ x)
}

/// Some left out.
#[function]
pub fn skipped(values: &[u8; 3], n: u8) -> u8 {
    let mut sum = 0;
    for (x, i) in values.iter().zip(n..).skip(1) {
        sum ^= i ^ x;
    }
    sum
}

/// By hand.
#[function]
pub fn by_hand(values: &[u8; 3], n: u8) -> Option<(u8, u8)> {
    let mut pairs = (n..).zip(values.iter().copied());
    pairs.next();
    pairs.next()
}
