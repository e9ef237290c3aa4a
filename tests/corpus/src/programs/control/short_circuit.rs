//! `&&` and `||` leave the right side out when the left decides, faults included.

use bessemer::prelude::*;

/// Returns true if the divisor divides; no division by zero happens.
#[function]
pub fn divides(n: u32, divisor: u32) -> bool {
    divisor != 0 && n % divisor == 0
}

/// Returns true if the element is out of reach or too large.
#[function]
pub fn unusable(values: &[i32; 3], at: usize) -> bool {
    at >= 3 || values[at] > 100
}
