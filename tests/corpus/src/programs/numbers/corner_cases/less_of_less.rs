//! A number below another stays below it when something is subtracted from it, but not when that is subtracted from
//! the other.

use bessemer::prelude::*;

/// Subtracts a negative distance, which is no reason for `x` to stay below `n`.
#[function]
pub fn behind(x: i32, n: i32) -> i32 {
    if x < n {
        assert!(x - (-5) < n);
        return n - x;
    }
    0
}

/// Subtracts a negative distance from a float.
#[function]
pub fn before(x: f64, n: f64) -> f64 {
    if x < n {
        assert!(x - (-5.0) < n);
        return n - x;
    }
    0.0
}

/// The elements before and after an index below the length.
#[function]
pub fn beside(values: &[u8], at: usize) -> u8 {
    if at < values.len() {
        return values[at - 1] ^ values[at + 1];
    }
    0
}
