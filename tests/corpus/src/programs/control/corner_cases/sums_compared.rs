//! Loops that increment a part of the compared expression: a sum, a difference, a product, a square.

use bessemer::prelude::*;

/// The sum of the products of each number with the one two places later.
#[function]
pub fn correlated(values: &[u8; 16], used: usize) -> u32 {
    let n = used.min(values.len());
    let (mut i, mut sum) = (0, 0);
    while i + 2 < n {
        sum += u32::from(values[i]) * u32::from(values[i + 2]);
        i += 1;
    }
    sum
}

/// Number of times that `by` fits between `low` and `high`; a negative difference is a fault, as in Rust.
#[function]
pub fn fits(low: u8, high: u8, by: u8) -> u32 {
    let (mut high, mut count) = (high, 0);
    while low <= high - by {
        high -= 1;
        count += 1;
    }
    count
}

/// Returns true if a number has no divisor but itself.
#[function]
pub fn is_prime(n: u16) -> bool {
    let (n, mut divisor) = (u32::from(n), 2);
    while divisor * divisor <= n {
        if n % divisor == 0 {
            return false;
        }
        divisor += 1;
    }
    n > 1
}

/// The last index of three non-decreasing values in a row.
#[function]
pub fn rising(values: &[i16; 12]) -> Option<usize> {
    let mut at = 0;
    let mut found = None;
    while at + 2 < values.len() && values[at] < 1_000 {
        if values[at] <= values[at + 1] && values[at + 1] <= values[at + 2] {
            found = Some(at);
        }
        at += 1;
    }
    found
}

/// Doubles a number until three times it reaches `wanted`.
#[function]
pub fn enough(wanted: u16) -> u32 {
    let (wanted, mut offered) = (u32::from(wanted), 1);
    while 3 * offered < wanted {
        offered = offered + offered + 1;
    }
    offered
}
