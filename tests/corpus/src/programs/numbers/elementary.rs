//! Elementary functions are the DSL's own, written in the DSL: the same bits on every target.

use bessemer::prelude::*;

/// The distance on a sphere between two points of the same longitude, m.
#[function]
pub fn arc(radius: f64, one: f64, other: f64) -> f64 {
    let half = ((one - other) / 2.0).sin();
    2.0 * radius * half.abs().min(1.0).asin()
}

/// Heading of a direction, rad.
#[function]
pub fn heading(east: f32, north: f32) -> f32 {
    east.atan2(north)
}
