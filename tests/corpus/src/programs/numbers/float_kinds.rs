//! Tests for NaN, infinities and the sign of zero.

use bessemer::prelude::*;

/// A measurement, or the previous value if it is not finite.
#[function]
pub fn usable(measured: f64, before: f64) -> f64 {
    if measured.is_finite() { measured } else { before }
}

/// The sign of a command, also for −0.
#[function]
pub fn direction(command: f64) -> f64 {
    1.0_f64.copysign(command)
}
