#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Patterns that do more than compare.
#[function]
pub fn patterns(n: i32) -> i32 {
    let (low, high) = (1, 2);
    match n {
        0..=9 => low,
        m if m > 100 => high,
        big @ 50 => big,
        other => other,
    }
}

fn main() {}
