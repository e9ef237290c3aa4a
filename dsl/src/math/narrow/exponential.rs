//! The exponentials: whole powers of two, by their bits, and a polynomial for what is left.

use core::f32::consts::LOG2_E;

use super::super::RawBits as _;
use super::super::tables::{NARROW_BINARY, NARROW_EXPONENTIAL, NARROW_LN_2_HIGH, NARROW_LN_2_LOW};
use super::{TO_INTEGER, ordered_sum};
use crate::prelude::*;

/// 2^`steps` times a number that stays normal; of `steps` the last nine bits count.
#[inline]
#[function]
pub fn scaled(x: f32, steps: u32) -> f32 {
    f32::from_bits(x.raw_bits().wrapping_add(steps << 23))
}

/// 2^`steps` times a number from 1/2 to 2, for a result of any size.
#[function]
pub fn far_scaled(x: f32, steps: i32) -> f32 {
    if steps > 0 {
        // By 2⁶⁴ at last.
        scaled(x, steps.wrapping_sub(64) as u32) * 18_446_744_000_000_000_000.0
    } else {
        scaled(x, steps.wrapping_add(64) as u32) * 5.421011e-20
    }
}

/// An exponent as whole powers of two and what is left of it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepsF32 {
    /// Whole powers of two.
    pub steps: i32,
    /// The exponent that is left, −0.35 to 0.35: exact.
    pub high: f32,
    /// What is taken off it yet.
    pub low: f32,
}

/// Takes multiples of ln 2 off an exponent from −120 to 120.
#[inline]
#[function]
pub fn steps_of(x: f32) -> StepsF32 {
    let shifted = x * LOG2_E + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    StepsF32 {
        steps: shifted.raw_bits().wrapping_sub(0x4b40_0000) as i32,
        high: x - steps * NARROW_LN_2_HIGH,
        low: steps * NARROW_LN_2_LOW,
    }
}

/// What e^(`high` − `low`) has beyond 1 + `high`.
#[inline]
#[function]
pub fn beyond(exponent: StepsF32) -> f32 {
    let r = exponent.high - exponent.low;
    let upper = NARROW_EXPONENTIAL[2]
        + r * (NARROW_EXPONENTIAL[3] + r * (NARROW_EXPONENTIAL[4] + r * NARROW_EXPONENTIAL[5]));
    let curve = r * r * (NARROW_EXPONENTIAL[0] + r * (NARROW_EXPONENTIAL[1] + r * upper));
    curve - exponent.low
}

/// e^x where it is no normal number, and next to the largest.
#[function]
pub fn far_exponential(x: f32) -> f32 {
    if x > 88.73 {
        f32::INFINITY
    } else if x < -103.98 {
        0.0
    } else if x.is_nan() {
        x
    } else {
        let exponent = steps_of(x);
        far_scaled(1.0 + (exponent.high + beyond(exponent)), exponent.steps)
    }
}

/// e^x; within 1 ulp. −∞ gives 0, what overflows ∞, NaN gives NaN.
#[function]
pub fn expf(x: f32) -> f32 {
    if x.abs() < 87.0 {
        let exponent = steps_of(x);
        scaled(1.0 + (exponent.high + beyond(exponent)), exponent.steps as u32)
    } else {
        far_exponential(x)
    }
}

/// What 2^r has beyond 1 + r, for −1/2 to 1/2.
#[inline]
#[function]
fn beyond_binary(r: f32) -> f32 {
    let upper = NARROW_BINARY[3] + r * (NARROW_BINARY[4] + r * NARROW_BINARY[5]);
    r * (NARROW_BINARY[0] + r * (NARROW_BINARY[1] + r * (NARROW_BINARY[2] + r * upper)))
}

/// 2^x where it is no normal number, and next to the largest.
#[function]
pub fn far_binary(x: f32) -> f32 {
    if x >= 128.0 {
        f32::INFINITY
    } else if x < -150.0 {
        0.0
    } else if x.is_nan() {
        x
    } else {
        let shifted = x + TO_INTEGER;
        let steps = shifted.raw_bits().wrapping_sub(0x4b40_0000) as i32;
        let r = x - (shifted - TO_INTEGER);
        far_scaled(1.0 + (r + beyond_binary(r)), steps)
    }
}

/// 2^x; within 1 ulp. −∞ gives 0, what overflows ∞, NaN gives NaN.
#[function]
pub fn exp2f(x: f32) -> f32 {
    if x.abs() < 126.0 {
        let shifted = x + TO_INTEGER;
        let r = x - (shifted - TO_INTEGER);
        scaled(1.0 + (r + beyond_binary(r)), shifted.raw_bits())
    } else {
        far_binary(x)
    }
}

/// e^x − 1, without cancellation; within 1 ulp. ±0 gives ±0, −∞ gives −1, what overflows ∞, NaN
/// gives NaN.
#[function]
pub fn exp_m1f(x: f32) -> f32 {
    let size = x.abs();
    // A little beyond the range of the polynomial it still is the better one: measured.
    if size < 0.385 {
        // −0 stays what it is.
        let whole = StepsF32 { steps: 0, high: x, low: 0.0 };
        return if size < 5.9604645e-8 { x } else { x + beyond(whole) };
    }
    if x > -17.4 && x < 16.5 {
        // So few steps that the power less 1 is exact.
        let exponent = steps_of(x);
        let scale = scaled(1.0, exponent.steps as u32);
        let lead = ordered_sum(scale - 1.0, scale * exponent.high);
        lead.high + (lead.low + scale * beyond(exponent))
    } else if x < 0.0 {
        -1.0
    } else if x < 40.0 {
        let exponent = steps_of(x);
        let scale = scaled(1.0, exponent.steps as u32);
        let lead = ordered_sum(scale, scale * exponent.high);
        lead.high + (lead.low + (scale * beyond(exponent) - 1.0))
    } else {
        expf(x)
    }
}
