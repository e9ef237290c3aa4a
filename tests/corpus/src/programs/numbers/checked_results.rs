//! `checked_…` gives the result where there is one; it never faults.

use bessemer::prelude::*;

/// The area of a field of pixels, if it can be counted.
#[function]
pub fn area(width: u16, height: u16) -> Option<u16> {
    width.checked_mul(height)
}

/// Distance from one count to another, or 0.
#[function]
pub fn distance(from: i32, to: i32) -> i32 {
    to.checked_sub(from).unwrap_or(0)
}
