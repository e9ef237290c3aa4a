//! Roundings that IEEE 754 defines take one instruction or a few.

use bessemer::prelude::*;

/// A position rounded to a grid of 0.25.
#[function]
pub fn snapped(x: f64) -> f64 {
    (x * 4.0).round() / 4.0
}

/// Whole part and fraction.
#[function]
pub fn parts(x: f32) -> [f32; 2] {
    [x.trunc(), x.fract()]
}

/// Number of pages for `bytes`.
#[function]
pub fn pages(bytes: f64) -> f64 {
    (bytes / 512.0).ceil().max((bytes / 4096.0).floor())
}
