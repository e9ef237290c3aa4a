//! Comparisons work as in Rust: for floats as in IEEE 754, where a NaN is unequal to everything.

use bessemer::prelude::*;

/// Returns true if a value is strictly between two limits.
#[function]
pub fn inside(value: f64, low: f64, high: f64) -> bool {
    low < value && value < high
}

/// The order of three numbers: 1 if ascending, −1 if descending, otherwise 0.
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
