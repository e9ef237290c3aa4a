//! `Option` is a struct: a flag for whether there is a value, and the value (zero if there is none).

use bessemer::prelude::*;

/// The slope of a line through two points; `None` if it is vertical.
#[function]
pub fn slope(from: [f64; 2], to: [f64; 2]) -> Option<f64> {
    let run = to[0] - from[0];
    if run == 0.0 { None } else { Some((to[1] - from[1]) / run) }
}

/// The slope, or `other` if the line is vertical.
#[function]
pub fn slope_or(from: [f64; 2], to: [f64; 2], other: f64) -> f64 {
    slope(from, to).unwrap_or(other)
}

/// The larger of two readings that may be missing.
#[function]
pub fn better(one: Option<u8>, other: Option<u8>) -> Option<u8> {
    match (one, other) {
        (Some(a), Some(b)) => Some(a.max(b)),
        (one, None) => one,
        (None, other) => other,
    }
}
