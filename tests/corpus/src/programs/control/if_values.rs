//! `if` is a statement or a value.

use bessemer::prelude::*;

/// A gain that depends on the mode and on the size of the error.
#[function]
pub fn gain(fast: bool, error: f64) -> f64 {
    let base = if fast { 2.0 } else { 0.5 };
    if error.abs() > 1.0 {
        base * 2.0
    } else if error.abs() > 0.1 {
        base
    } else {
        0.0
    }
}
