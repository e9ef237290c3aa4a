//! The hyperbolic functions: polynomials near zero, and otherwise from the exponentials before their last rounding.

use super::super::tables::{NARROW_SINH, NARROW_TANH};
use super::exponential::{StepsF32, beyond, far_scaled, scaled, steps_of};
use super::ordered_sum;
use super::tangent::TINY;
use crate::prelude::*;

/// Coefficient of x² in the Taylor series of e^x. Up to |x| = (ln 2)/2 the omitted even terms are below 2⁻²⁷, and the
/// odd ones below 2⁻³⁰ of x.
#[crate::data]
const E2: f32 = 1.0 / 2.0;
/// Coefficient of x³.
#[crate::data]
const E3: f32 = 1.0 / 6.0;
/// Coefficient of x⁴.
#[crate::data]
const E4: f32 = 1.0 / 24.0;
/// Coefficient of x⁵.
#[crate::data]
const E5: f32 = 1.0 / 120.0;
/// Coefficient of x⁶.
#[crate::data]
const E6: f32 = 1.0 / 720.0;
/// Coefficient of x⁷.
#[crate::data]
const E7: f32 = 1.0 / 5_040.0;

/// Up to this number e^(−x) changes the sum with e^x.
#[crate::data]
const BOTH: f32 = 9.0;

/// The even part of e^r, less 1, for `z` = r² up to 0.12.
#[inline]
#[function]
fn even_part(z: f32) -> f32 {
    z * (E2 + z * (E4 + z * E6))
}

/// Half of e^x + `sign` · e^(−x), for x from 0.35 to 9, or from 1.04 if `sign` is −1; `exponent` is that of e^x.
#[inline]
#[function]
fn half_of_both(exponent: StepsF32, sign: f32) -> f32 {
    let r = exponent.high - exponent.low;
    let z = r * r;
    let even = even_part(z);
    let odd = r * z * (E3 + z * (E5 + z * E7)) - exponent.low;
    let rising = scaled(0.5, exponent.steps as u32);
    let falling = sign * scaled(0.5, 0u32.wrapping_sub(exponent.steps as u32));
    let lead = ordered_sum(rising, rising * exponent.high);
    let rest = rising * (even + odd) + falling * (1.0 + (even - (exponent.high + odd)));
    lead.high + (lead.low + rest)
}

/// Half of e^x for x from 9 on, and for NaN.
#[function]
pub fn far_half(size: f32) -> f32 {
    if size < 90.0 {
        let exponent = steps_of(size);
        far_scaled(1.0 + (exponent.high + beyond(exponent)), exponent.steps.wrapping_sub(1))
    } else if size >= 90.0 {
        f32::INFINITY
    } else {
        size
    }
}

/// The hyperbolic sine; within 1 ulp. ±0 gives ±0, an overflow gives ±∞, NaN gives NaN.
#[function]
pub fn sinhf(x: f32) -> f32 {
    let size = x.abs();
    if size < 1.05 {
        let z = x * x;
        let tail =
            NARROW_SINH[0] + z * (NARROW_SINH[1] + z * (NARROW_SINH[2] + z * NARROW_SINH[3]));
        return if size < TINY { x } else { x + x * z * tail };
    }
    let value = if size < BOTH { half_of_both(steps_of(size), -1.0) } else { far_half(size) };
    if x < 0.0 { -value } else { value }
}

/// The hyperbolic cosine; within 1 ulp. ±0 gives 1, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn coshf(x: f32) -> f32 {
    let size = x.abs();
    if size < 0.34 {
        1.0 + even_part(x * x)
    } else if size < BOTH {
        half_of_both(steps_of(size), 1.0)
    } else {
        far_half(size)
    }
}

/// The hyperbolic tangent; within 1 ulp. ±0 gives ±0, ±∞ gives ±1, NaN gives NaN.
#[function]
pub fn tanhf(x: f32) -> f32 {
    let size = x.abs();
    if size < 0.75 {
        let z = x * x;
        let upper =
            NARROW_TANH[3] + z * (NARROW_TANH[4] + z * (NARROW_TANH[5] + z * NARROW_TANH[6]));
        let tail = NARROW_TANH[0] + z * (NARROW_TANH[1] + z * (NARROW_TANH[2] + z * upper));
        return if size < TINY { x } else { x + x * z * tail };
    }
    let value = if size < 9.1 {
        // 1 − 2/(e^(2x) + 1).
        let exponent = steps_of(2.0 * size);
        let scale = scaled(1.0, exponent.steps as u32);
        let lead = ordered_sum(scale + 1.0, scale * exponent.high);
        let sum = ordered_sum(lead.high, lead.low + scale * beyond(exponent));
        let part = 2.0 / sum.high;
        // What the sum lost changes its reciprocal.
        let lead = ordered_sum(1.0, -part);
        lead.high + (lead.low + 0.5 * part * part * sum.low)
    } else if size >= 9.1 {
        1.0
    } else {
        size
    };
    if x < 0.0 { -value } else { value }
}
