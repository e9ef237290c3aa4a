//! The exponential functions: a power of two by its bits, 128ths of an exponent from a table, and a short polynomial
//! for the remainder. e^x − 1 and the hyperbolic functions use no table and a longer polynomial.

use core::f32::consts::{LN_2, LOG2_E};

use super::super::RawBits as _;
use super::super::tables::{
    NARROW_EXPONENTIAL, NARROW_LN_2_HIGH, NARROW_LN_2_LOW, NARROW_OF_TWO, NARROW_STEP_LN_2_HIGH,
    NARROW_STEP_LN_2_LOW,
};
use super::{TO_INTEGER, ordered_sum};
use crate::prelude::*;

/// 2^`steps` times a number whose result is normal; only the last nine bits of `steps` count.
#[inline]
#[function]
pub(crate) fn scaled(x: f32, steps: u32) -> f32 {
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

/// An exponent as a multiple of ln 2 and a remainder.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepsF32 {
    /// The multiple: the exponent of a power of two.
    pub steps: i32,
    /// The leading part of the remainder, −0.35 to 0.35: exact.
    pub high: f32,
    /// The rest of the remainder, to be subtracted.
    pub low: f32,
}

/// Splits an exponent from −120 to 120 into a multiple of ln 2 and a remainder.
#[inline]
#[function]
pub(crate) fn steps_of(x: f32) -> StepsF32 {
    let shifted = x * LOG2_E + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    StepsF32 {
        steps: shifted.raw_bits().wrapping_sub(0x4b40_0000) as i32,
        high: x - steps * NARROW_LN_2_HIGH,
        low: steps * NARROW_LN_2_LOW,
    }
}

/// e^(`high` − `low`) minus 1 + `high`.
#[inline]
#[function]
pub(crate) fn beyond(exponent: StepsF32) -> f32 {
    let r = exponent.high - exponent.low;
    let upper = NARROW_EXPONENTIAL[2]
        + r * (NARROW_EXPONENTIAL[3] + r * (NARROW_EXPONENTIAL[4] + r * NARROW_EXPONENTIAL[5]));
    let curve = r * r * (NARROW_EXPONENTIAL[0] + r * (NARROW_EXPONENTIAL[1] + r * upper));
    curve - exponent.low
}

/// 1.5 · 2¹⁶: added to a smaller number it leaves the nearest 128th in the last bits.
#[crate::data]
pub(crate) const TO_STEPS: f32 = 98_304.0;

/// The bits of [`TO_STEPS`].
#[crate::data]
const NO_STEPS: u32 = 0x47c0_0000;

/// An exponent as a number of 128ths and a remainder.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExponentF32 {
    /// The bits of the number of 128ths plus `TO_STEPS`: the last seven choose a row, the others are the exponent of
    /// a power of two.
    pub bits: u32,
    /// The remainder.
    pub rest: f32,
}

/// 2^(`steps`/128) · (1 + `beyond`): the last seven bits of `steps` choose a row, the others are the exponent of a
/// power of two.
#[inline]
#[function]
pub(crate) fn step_power(steps: u32, beyond: f32) -> f32 {
    let row = (steps & 127) as usize;
    let base = f32::from_bits(NARROW_OF_TWO[row][1].wrapping_add(steps << 16));
    base + base * (f32::from_bits(NARROW_OF_TWO[row][0]) + beyond)
}

/// [`step_power`] for a result that is not a normal number; `bits` is that of [`ExponentF32`].
#[function]
pub fn far_step_power(bits: u32, beyond: f32) -> f32 {
    let whole = bits.wrapping_sub(NO_STEPS) as i32 >> 7;
    far_scaled(step_power(bits & 127, beyond), whole)
}

/// Coefficient of r in the Taylor series of e^r, including the best linear approximation of r³'s term. Up to |r| =
/// (ln 2)/256 the error is below 2⁻³⁰.
#[crate::data]
const FIRST: f32 = 1.0 + LN_2 * LN_2 / 8.0 / 65_536.0;

/// Splits an exponent from −120 to 120 into 128ths of ln 2 and a remainder of at most (ln 2)/256.
#[inline]
#[function]
fn natural_steps(x: f32) -> ExponentF32 {
    let shifted = x * LOG2_E + TO_STEPS;
    let steps = shifted - TO_STEPS;
    let rest = (x - steps * NARROW_STEP_LN_2_HIGH) - steps * NARROW_STEP_LN_2_LOW;
    ExponentF32 { bits: shifted.raw_bits(), rest }
}

/// e^r − 1 for r from −(ln 2)/256 to (ln 2)/256.
#[inline]
#[function]
fn natural_beyond(r: f32) -> f32 {
    r * (FIRST + 0.5 * r)
}

/// e^x where the result is near the limits of the normal numbers, or beyond.
#[function]
pub fn far_exponential(x: f32) -> f32 {
    if x > 88.73 {
        f32::INFINITY
    } else if x < -103.98 {
        0.0
    } else if x.is_nan() {
        x
    } else {
        let exponent = natural_steps(x);
        far_step_power(exponent.bits, natural_beyond(exponent.rest))
    }
}

/// e^x; within 1 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn expf(x: f32) -> f32 {
    // Beyond, what is added to a row's power could lose bits below the normal numbers.
    if x.abs() < 80.0 {
        let exponent = natural_steps(x);
        step_power(exponent.bits, natural_beyond(exponent.rest))
    } else {
        far_exponential(x)
    }
}

/// Coefficient of r in the Taylor series of 2^r, including the best linear approximation of r³'s term. Up to |r| =
/// 1/256 the error is below 2⁻³⁰.
#[crate::data]
const BINARY_FIRST: f32 = LN_2 + LN_2 * LN_2 * LN_2 / 8.0 / 65_536.0;
/// Coefficient of r².
#[crate::data]
const BINARY_SECOND: f32 = LN_2 * LN_2 / 2.0;

/// 2^r − 1 for r from −1/256 to 1/256.
#[inline]
#[function]
pub(crate) fn binary_beyond(r: f32) -> f32 {
    r * (BINARY_FIRST + BINARY_SECOND * r)
}

/// 2^x where the result is near the limits of the normal numbers, or beyond.
#[function]
pub fn far_binary(x: f32) -> f32 {
    if x >= 128.0 {
        f32::INFINITY
    } else if x < -150.0 {
        0.0
    } else if x.is_nan() {
        x
    } else {
        let shifted = x + TO_STEPS;
        far_step_power(shifted.raw_bits(), binary_beyond(x - (shifted - TO_STEPS)))
    }
}

/// 2^x; within 1 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn exp2f(x: f32) -> f32 {
    // Beyond, what is added to a row's power could lose bits below the normal numbers.
    if x.abs() < 115.0 {
        let shifted = x + TO_STEPS;
        step_power(shifted.raw_bits(), binary_beyond(x - (shifted - TO_STEPS)))
    } else {
        far_binary(x)
    }
}

/// e^x − 1, without cancellation; within 1 ulp. ±0 gives ±0, −∞ gives −1, an overflow gives ∞, NaN gives NaN.
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
