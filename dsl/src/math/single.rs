//! The elementary functions in single precision: computed in double, rounded once.

use super::arctangent::{acos, asin, atan, atan2};
use super::exponential::{exp, exp_m1, exp2};
use super::hyperbolic::{cosh, sinh, tanh};
use super::logarithm::{ln, ln_1p, log2, log10};
use super::power::{powf, powi};
use super::roots::{cbrt, hypot};
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

/// Arcsine, rad; NaN outside −1 to 1.
#[function]
pub fn asinf(x: f32) -> f32 {
    asin(x as f64) as f32
}

/// Arccosine, rad; NaN outside −1 to 1.
#[function]
pub fn acosf(x: f32) -> f32 {
    acos(x as f64) as f32
}

/// Arctangent, rad.
#[function]
pub fn atanf(x: f32) -> f32 {
    atan(x as f64) as f32
}

/// e^x.
#[function]
pub fn expf(x: f32) -> f32 {
    exp(x as f64) as f32
}

/// 2^x.
#[function]
pub fn exp2f(x: f32) -> f32 {
    exp2(x as f64) as f32
}

/// e^x − 1, without cancellation.
#[function]
pub fn exp_m1f(x: f32) -> f32 {
    exp_m1(x as f64) as f32
}

/// The natural logarithm.
#[function]
pub fn lnf(x: f32) -> f32 {
    ln(x as f64) as f32
}

/// The logarithm to base 2.
#[function]
pub fn log2f(x: f32) -> f32 {
    log2(x as f64) as f32
}

/// The logarithm to base 10.
#[function]
pub fn log10f(x: f32) -> f32 {
    log10(x as f64) as f32
}

/// ln(1 + x), without cancellation.
#[function]
pub fn ln_1pf(x: f32) -> f32 {
    ln_1p(x as f64) as f32
}

/// The hyperbolic sine.
#[function]
pub fn sinhf(x: f32) -> f32 {
    sinh(x as f64) as f32
}

/// The hyperbolic cosine.
#[function]
pub fn coshf(x: f32) -> f32 {
    cosh(x as f64) as f32
}

/// The hyperbolic tangent.
#[function]
pub fn tanhf(x: f32) -> f32 {
    tanh(x as f64) as f32
}

/// The cube root.
#[function]
pub fn cbrtf(x: f32) -> f32 {
    cbrt(x as f64) as f32
}

/// The angle of the point (`x`, `y`) in rad, −π to π.
#[function]
pub fn atan2f(y: f32, x: f32) -> f32 {
    atan2(y as f64, x as f64) as f32
}

/// x^y.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    powf(x as f64, y as f64) as f32
}

/// √(x² + y²).
#[function]
pub fn hypotf(x: f32, y: f32) -> f32 {
    hypot(x as f64, y as f64) as f32
}

/// x^n: the product in double, rounded once.
#[function]
pub fn powif(x: f32, n: i32) -> f32 {
    powi(x as f64, n) as f32
}
