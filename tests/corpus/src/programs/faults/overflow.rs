//! The C reports a fault where Rust panics on overflow, also for the negative of the lowest number.

use bessemer::prelude::*;

/// The distance on a line.
#[function]
pub fn distance(a: i32, b: i32) -> i32 {
    (a - b).abs()
}
