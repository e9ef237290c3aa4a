//! `clamp` with limits in the wrong order is a fault.

use bessemer::prelude::*;

/// A value within limits that the caller sets.
#[function]
pub fn within(value: f64, low: f64, high: f64) -> f64 {
    value.clamp(low, high)
}
