//! The inverse trigonometric functions.
//!
//! The arctangent: for the nearest c of a table, with four entries for each octave from 1/4 to 4, atan x = atan c +
//! atan((x − c) / (1 + x·c)), and the last is a polynomial. For two coordinates the argument is (y − c·x) / (x +
//! c·y). Arcsine and arccosine are a polynomial up to 1/2, and from there on asin x = π/2 − 2·asin √((1 − x)/2).

use super::super::RawBits as _;
use super::super::tables::{
    NARROW_ARCSINE, NARROW_ARCTANGENT, NARROW_ARCTANGENT_ROWS, NARROW_HALF_PI_HIGH,
    NARROW_HALF_PI_LOW,
};
use super::tangent::TINY;
use super::{PairF32, leading, ordered_sum};
use crate::prelude::*;

/// Coefficient of x³ in the Taylor series of the arctangent. Up to |x| = 1/16 the omitted terms are below 2⁻²⁶ of it.
#[crate::data]
const A3: f32 = -1.0 / 3.0;
/// Coefficient of x⁵.
#[crate::data]
const A5: f32 = 1.0 / 5.0;

/// The row for a ratio: 0 to 15 from 1/4 to 4, more outside.
#[inline]
#[function]
fn row_of_ratio(ratio: f32) -> u32 {
    // The exponent and two bits more, less those of 1/4.
    (ratio.raw_bits() >> 21).wrapping_sub(0x1f4)
}

/// The arctangent of `t` minus `t`, for |t| ≤ 1/16.
#[inline]
#[function]
fn small_curve(t: f32) -> f32 {
    let z = t * t;
    t * z * (A3 + z * A5)
}

/// The arctangent of `t` minus `t`, for |t| ≤ 1/4.
#[inline]
#[function]
fn curve(t: f32) -> f32 {
    let z = t * t;
    let upper = NARROW_ARCTANGENT[2] + z * NARROW_ARCTANGENT[3];
    t * z * (NARROW_ARCTANGENT[0] + z * (NARROW_ARCTANGENT[1] + z * upper))
}

/// Arctangent, rad; within 1 ulp. ±0 gives ±0, ±∞ gives ±π/2, NaN gives NaN.
#[function]
pub fn atanf(x: f32) -> f32 {
    let size = x.abs();
    let row = row_of_ratio(size);
    let value = if row < 16 {
        let centre = NARROW_ARCTANGENT_ROWS[row as usize][0];
        let t = (size - centre) / (1.0 + size * centre);
        NARROW_ARCTANGENT_ROWS[row as usize][1]
            + (NARROW_ARCTANGENT_ROWS[row as usize][2] + (t + small_curve(t)))
    } else if size < TINY {
        size
    } else if size < 1.0 {
        size + curve(size)
    } else {
        let t = 1.0 / size;
        NARROW_HALF_PI_HIGH + (NARROW_HALF_PI_LOW - (t + curve(t)))
    };
    if x < 0.0 {
        -value
    } else if x > 0.0 {
        value
    } else {
        // ±0 and NaN.
        x
    }
}

/// Angle of a point in the first quadrant, from 0 to π/2 rad, as a sum of two floats. `ratio` is `height`/`width`;
/// all three are from 2⁻⁶⁰ to 2⁶⁰.
#[inline]
#[function]
fn angle_of_ratio(height: f32, width: f32, ratio: f32) -> PairF32 {
    let row = row_of_ratio(ratio);
    if row < 16 {
        let centre = NARROW_ARCTANGENT_ROWS[row as usize][0];
        let upper = leading(width);
        let above = (height - centre * upper) - centre * (width - upper);
        let t = above / (width + centre * height);
        let low = NARROW_ARCTANGENT_ROWS[row as usize][2] + (t + small_curve(t));
        PairF32 { high: NARROW_ARCTANGENT_ROWS[row as usize][1], low }
    } else if ratio < 1.0 {
        // What the quotient is off by, from products without loss.
        let (upper, lead) = (leading(width), leading(ratio));
        let (lower, rest) = (width - upper, ratio - lead);
        let left = (((height - lead * upper) - lead * lower) - rest * upper) - rest * lower;
        PairF32 { high: ratio, low: left / width + curve(ratio) }
    } else {
        let t = width / height;
        PairF32 { high: NARROW_HALF_PI_HIGH, low: NARROW_HALF_PI_LOW - (t + curve(t)) }
    }
}

/// The angle as it is, or its supplement to π for a point on the left.
#[inline]
#[function]
fn angle_on_side(angle: PairF32, left: bool) -> f32 {
    if left {
        let rest = ordered_sum(2.0 * NARROW_HALF_PI_HIGH, -angle.high);
        rest.high + (rest.low + (2.0 * NARROW_HALF_PI_LOW - angle.low))
    } else {
        angle.high + angle.low
    }
}

/// The angle of the point (`x`, `y`) in rad, outside the common path. This is for special values and for coordinates
/// that are very large, very small or of very different size.
#[function]
pub fn far_atan2(y: f32, x: f32) -> f32 {
    let width = x.abs();
    let height = y.abs();
    let left = 1.0_f32.copysign(x) < 0.0;
    if width.is_nan() || height.is_nan() {
        return f32::NAN;
    }
    let angle = if width <= height && height <= width {
        // Both zero, both infinite, or on the diagonal.
        if width <= 0.0 {
            PairF32 { high: 0.0, low: 0.0 }
        } else {
            PairF32 { high: 0.5 * NARROW_HALF_PI_HIGH, low: 0.5 * NARROW_HALF_PI_LOW }
        }
    } else if height > width * 1_073_741_824.0 {
        // From 2³⁰ on, the result no longer changes.
        PairF32 { high: NARROW_HALF_PI_HIGH, low: NARROW_HALF_PI_LOW }
    } else if width * 9.313226e-10 > height {
        // By 2⁻³⁰ the smaller coordinate enters as it is.
        PairF32 { high: height / width, low: 0.0 }
    } else {
        // By 2^±60, so that no product leaves the range.
        let scale = if width > 1.0 { 8.6736174e-19 } else { 1_152_921_500_000_000_000.0 };
        angle_of_ratio(height * scale, width * scale, height / width)
    };
    angle_on_side(angle, left).copysign(y)
}

/// The angle of the point (`x`, `y`) in rad, −π to π; within 1 ulp. ±0, ±∞ and NaN as in C99,
/// F.9.1.4.
#[function]
pub fn atan2f(y: f32, x: f32) -> f32 {
    let width = x.abs();
    let height = y.abs();
    if width > 1e-15 && width < 1e15 && height > 1e-15 && height < 1e15 {
        let angle = angle_of_ratio(height, width, height / width);
        let value = angle_on_side(angle, x < 0.0);
        if y < 0.0 { -value } else { value }
    } else {
        far_atan2(y, x)
    }
}

/// (asin √z − √z)/z^(3/2) for z from 0 to 1/4.
#[inline]
#[function]
fn arcsine_curve(z: f32) -> f32 {
    let upper = NARROW_ARCSINE[2] + z * (NARROW_ARCSINE[3] + z * NARROW_ARCSINE[4]);
    NARROW_ARCSINE[0] + z * (NARROW_ARCSINE[1] + z * upper)
}

/// Half the arccosine of `size`, for `size` from 1/2 to 1, as the rounded root r of (1 − `size`)/2 and its
/// correction.
#[inline]
#[function]
fn half_arccosine(size: f32) -> PairF32 {
    let z = 0.5 - 0.5 * size;
    let root = z.sqrt();
    // What the root is off by is (z − r²)/2r; of nothing it is nothing.
    let lead = leading(root);
    let left = (z - lead * lead) - (root - lead) * (root + lead);
    let rest = if z > 0.0 { left / (root + root) } else { 0.0 };
    PairF32 { high: root, low: root * z * arcsine_curve(z) + rest }
}

/// Arcsine of −1 to 1, rad; within 1 ulp. ±0 gives ±0; numbers outside and NaN give NaN.
#[function]
pub fn asinf(x: f32) -> f32 {
    let size = x.abs();
    if size < 0.5 {
        let z = x * x;
        return if size < TINY { x } else { x + x * (z * arcsine_curve(z)) };
    }
    // Of what is negative the root is NaN.
    let half = half_arccosine(size);
    let lead = ordered_sum(NARROW_HALF_PI_HIGH, -2.0 * half.high);
    let value = lead.high + (lead.low + (NARROW_HALF_PI_LOW - 2.0 * half.low));
    if x < 0.0 { -value } else { value }
}

/// Arccosine of −1 to 1, rad; within 1 ulp. 1 gives 0; numbers outside and NaN give NaN.
#[function]
pub fn acosf(x: f32) -> f32 {
    let size = x.abs();
    if size < 0.5 {
        let z = x * x;
        let lead = ordered_sum(NARROW_HALF_PI_HIGH, -x);
        return lead.high + (lead.low + (NARROW_HALF_PI_LOW - x * (z * arcsine_curve(z))));
    }
    let half = half_arccosine(size);
    if x < 0.0 {
        let lead = ordered_sum(2.0 * NARROW_HALF_PI_HIGH, -2.0 * half.high);
        lead.high + (lead.low + (2.0 * NARROW_HALF_PI_LOW - 2.0 * half.low))
    } else {
        2.0 * (half.high + half.low)
    }
}
