//! Where Rust panics on overflow, the C reports a fault, for the negative of the smallest number, too.

use bessemer::prelude::*;

/// The distance on a line.
#[function]
pub fn distance(a: i32, b: i32) -> i32 {
    (a - b).abs()
}
