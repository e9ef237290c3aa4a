//! Functions call each other; small ones are inlined by the C compiler. Recursion is an error.

use bessemer::prelude::*;

/// The sign of a number as −1, 0 or 1.
#[function]
pub fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// A number reduced in magnitude by `width`, and 0 within it.
#[function]
pub fn dead_band(x: f64, width: f64) -> f64 {
    sign(x) * (x.abs() - width).max(0.0)
}

/// A stick's deflection with a dead band in the middle and a progressive curve outside.
#[function]
pub fn deflection(x: f64) -> f64 {
    let y = dead_band(x, 0.05);
    sign(y) * y * y
}
