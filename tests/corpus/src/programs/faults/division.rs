//! A division by zero, or of the lowest number by −1, is a fault.

use bessemer::prelude::*;

/// Count per period.
#[function]
pub fn rate(count: i32, period: i32) -> i32 {
    count / period
}

/// The divisor is at least 1, so no check is needed.
#[function]
pub fn safe_rate(count: u32, period: u32) -> u32 {
    count / period.max(1)
}
