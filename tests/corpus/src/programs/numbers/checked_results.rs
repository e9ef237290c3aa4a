//! `checked_…` returns the result if it fits, and never faults.

use bessemer::prelude::*;

/// The area of a rectangle of pixels; `None` on overflow.
#[function]
pub fn area(width: u16, height: u16) -> Option<u16> {
    width.checked_mul(height)
}

/// Distance from one count to another; 0 on overflow.
#[function]
pub fn distance(from: i32, to: i32) -> i32 {
    to.checked_sub(from).unwrap_or(0)
}
