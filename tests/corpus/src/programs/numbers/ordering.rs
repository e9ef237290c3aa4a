//! Comparisons are those of Rust: of floats as IEEE 754 has them, a NaN is unlike everything.

use bessemer::prelude::*;

/// Returns true if a value lies within limits, and is none of them.
#[function]
pub fn inside(value: f64, low: f64, high: f64) -> bool {
    low < value && value < high
}

/// The order of three numbers as −1, 0 or 1.
#[function]
pub fn ordered(a: i64, b: i64, c: i64) -> i8 {
    if a < b && b < c {
        1
    } else if a > b && b > c {
        -1
    } else {
        0
    }
}
