//! The elementary functions in single precision: computed in double, rounded once.

use super::arctangent::atan2;
use super::sine::{cos, sin};
use super::tangent::tan;
use crate::prelude::*;

/// Sine of an angle in rad.
#[function]
pub fn sinf(x: f32) -> f32 {
    sin(x as f64) as f32
}

/// Cosine of an angle in rad.
#[function]
pub fn cosf(x: f32) -> f32 {
    cos(x as f64) as f32
}

/// Tangent of an angle in rad.
#[function]
pub fn tanf(x: f32) -> f32 {
    tan(x as f64) as f32
}

/// The angle of the point (`x`, `y`) in rad, −π to π.
#[function]
pub fn atan2f(y: f32, x: f32) -> f32 {
    atan2(y as f64, x as f64) as f32
}
