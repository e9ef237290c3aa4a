//! The tangent: a polynomial of the angle reduced to a quarter turn, or the reciprocal of one in odd quarters.

use super::super::tables::{NARROW_HALF_PI_HIGH, NARROW_HALF_PI_LOW, NARROW_TANGENT};
use super::reduction::reduced_angle;
use super::{PairF32, leading, ordered_sum};
use crate::prelude::*;

/// 2⁻¹²: a smaller angle equals its sine and its tangent to the last bit.
#[crate::data]
pub(crate) const TINY: f32 = 2.4414063e-4;

/// Coefficient of x³ in the Taylor series of the tangent. Up to |x| = π/4 − 0.62 the omitted terms are below 2⁻²⁶ of
/// it.
#[crate::data]
const T3: f32 = 1.0 / 3.0;
/// Coefficient of x⁵.
#[crate::data]
const T5: f32 = 2.0 / 15.0;
/// Coefficient of x⁷.
#[crate::data]
const T7: f32 = 17.0 / 315.0;

/// Up to this angle, in rad, the polynomial loses little precision.
#[crate::data]
const MODERATE: f32 = 0.62;

/// Tangent of `high` + `low`, which is from −0.62 to 0.62.
#[inline]
#[function]
fn near_tangent(high: f32, low: f32) -> PairF32 {
    let z = high * high;
    let upper = NARROW_TANGENT[3]
        + z * (NARROW_TANGENT[4] + z * (NARROW_TANGENT[5] + z * NARROW_TANGENT[6]));
    let curve = high
        * z
        * (NARROW_TANGENT[0] + z * (NARROW_TANGENT[1] + z * (NARROW_TANGENT[2] + z * upper)));
    let value = high + curve;
    // The slope is 1 + tan².
    ordered_sum(high, curve + low * (1.0 + value * value))
}

/// Tangent of `high` + `low`, which is from 0.62 to π/4. It is 1 − 2t/(1 + t), where t is the tangent of π/4 less the
/// angle.
#[inline]
#[function]
fn steep_tangent(high: f32, low: f32) -> PairF32 {
    let left = 0.5 * NARROW_HALF_PI_HIGH - high;
    let z = left * left;
    let curve = (0.5 * NARROW_HALF_PI_LOW - low) + left * z * (T3 + z * (T5 + z * T7));
    let t = left + curve;
    // The same as 1 − 2t + 2t²/(1 + t).
    let lead = ordered_sum(1.0, -2.0 * left);
    ordered_sum(lead.high, lead.low + 2.0 * (t * t / (1.0 + t) - curve))
}

/// Tangent of an angle in rad, however large; within 1 ulp. ±0 gives ±0; ±∞ and NaN give NaN.
#[function]
pub fn tanf(x: f32) -> f32 {
    if x.abs() < TINY {
        // −0 stays what it is.
        return x;
    }
    let angle = reduced_angle(x);
    let tangent = if angle.high > MODERATE {
        steep_tangent(angle.high, angle.low)
    } else if angle.high < -MODERATE {
        let mirrored = steep_tangent(-angle.high, -angle.low);
        PairF32 { high: -mirrored.high, low: -mirrored.low }
    } else {
        near_tangent(angle.high, angle.low)
    };
    if (angle.quadrant & 1) == 0 {
        return tangent.high;
    }
    // −1/(high + low), with the exact product of high and the reciprocal.
    let guess = -1.0 / tangent.high;
    let upper = leading(tangent.high);
    let lower = (tangent.high - upper) + tangent.low;
    let lead = leading(guess);
    let off = (1.0 + lead * upper) + (lead * lower + (guess - lead) * tangent.high);
    guess + guess * off
}
