//! `clamp` with its limits the wrong way round is a fault.

use bessemer::prelude::*;

/// A value within limits that someone else sets.
#[function]
pub fn within(value: f64, low: f64, high: f64) -> f64 {
    value.clamp(low, high)
}
