#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Patterns that do more than compare and name: what is computed has no place to refer to.
#[function]
pub fn patterns(n: i32) -> i32 {
    let (low, high) = (1, 2);
    let [first, rest @ ..] = [1, 2, 3];
    let (mut left, mut right) = (first, rest[0]);
    (left, right) = (right, left);
    match n.wrapping_mul(low) {
        0..=9 => low,
        ref m if *m > 100 => high,
        other => other + left - right,
    }
}

fn main() {}
