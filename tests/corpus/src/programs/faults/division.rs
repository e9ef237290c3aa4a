//! A division by zero, or of the smallest number by −1, is a fault.

use bessemer::prelude::*;

/// Parts per period.
#[function]
pub fn rate(count: i32, period: i32) -> i32 {
    count / period
}

/// The divisor is at least 1: no check is left.
#[function]
pub fn safe_rate(count: u32, period: u32) -> u32 {
    count / period.max(1)
}
