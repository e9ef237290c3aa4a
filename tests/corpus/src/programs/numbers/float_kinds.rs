//! Tests for NaN, infinities and the sign of zero.

use bessemer::prelude::*;

/// A measurement, or the value before where it is none.
#[function]
pub fn usable(measured: f64, before: f64) -> f64 {
    if measured.is_finite() { measured } else { before }
}

/// The direction of a command, also of −0.
#[function]
pub fn direction(command: f64) -> f64 {
    1.0_f64.copysign(command)
}
