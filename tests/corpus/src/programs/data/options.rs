//! `Option` is a struct: whether there is a value, and the value (zero where there is none).

use bessemer::prelude::*;

/// The slope of a line through two points; none if it stands upright.
#[function]
pub fn slope(from: [f64; 2], to: [f64; 2]) -> Option<f64> {
    let run = to[0] - from[0];
    if run == 0.0 { None } else { Some((to[1] - from[1]) / run) }
}

/// The slope, or a stand-in.
#[function]
pub fn slope_or(from: [f64; 2], to: [f64; 2], other: f64) -> f64 {
    slope(from, to).unwrap_or(other)
}

/// The better of two readings, as far as there are any.
#[function]
pub fn better(one: Option<u8>, other: Option<u8>) -> Option<u8> {
    match (one, other) {
        (Some(a), Some(b)) => Some(a.max(b)),
        (one, None) => one,
        (None, other) => other,
    }
}
