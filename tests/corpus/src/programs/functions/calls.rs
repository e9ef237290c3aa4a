//! Functions call each other; small ones are left to the C compiler to inline. Recursion is refused.

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

/// A number whose size is cut off.
#[function]
pub fn dead_band(x: f64, width: f64) -> f64 {
    sign(x) * (x.abs() - width).max(0.0)
}

/// A stick's deflection, dead in the middle and progressive outside.
#[function]
pub fn deflection(x: f64) -> f64 {
    let y = dead_band(x, 0.05);
    sign(y) * y * y
}
