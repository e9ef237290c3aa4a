//! `&&` and `||` do not evaluate the right side if the left side decides, so it cannot fault.

use bessemer::prelude::*;

/// Returns true if the divisor divides `n`; a divisor of 0 is no fault.
#[function]
pub fn divides(n: u32, divisor: u32) -> bool {
    divisor != 0 && n % divisor == 0
}

/// Returns true if the index is out of range or the element too large.
#[function]
pub fn unusable(values: &[i32; 3], at: usize) -> bool {
    at >= 3 || values[at] > 100
}
