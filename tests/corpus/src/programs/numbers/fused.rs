//! `x.mul_add(a, b)` is x · a + b rounded once, on a target with a fused multiply-add and on one without.

use bessemer::prelude::*;

/// Rounding error of a product, for any numbers.
#[function]
pub fn lost(a: f64, b: f64) -> f64 {
    a.mul_add(b, -(a * b))
}

/// A quadratic by Horner's rule.
#[function]
pub fn quadratic(x: f32, a: f32, b: f32, c: f32) -> f32 {
    f32::mul_add(x.mul_add(a, b), x, c)
}
