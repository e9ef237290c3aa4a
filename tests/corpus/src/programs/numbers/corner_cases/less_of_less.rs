//! A number that is below another stays below it when something is subtracted, unless it is subtracted from the other
//! side.

use bessemer::prelude::*;

/// A distance that is negative is added.
#[function]
pub fn behind(x: i32, n: i32) -> i32 {
    if x < n {
        assert!(x - (-5) < n);
        return n - x;
    }
    0
}

/// The case of floats.
#[function]
pub fn before(x: f64, n: f64) -> f64 {
    if x < n {
        assert!(x - (-5.0) < n);
        return n - x;
    }
    0.0
}

/// The index before one below the length, and the one behind it.
#[function]
pub fn beside(values: &[u8], at: usize) -> u8 {
    if at < values.len() {
        return values[at - 1] ^ values[at + 1];
    }
    0
}
