//! The inverse trigonometric functions.
//!
//! The arctangent uses the nearest c of a table, with eight entries for each octave from 1/16 to 16. There
//! atan x = atan c + atan((x − c) / (1 + x·c)), and the last is a polynomial. For two coordinates the argument is
//! (y − c·x) / (x + c·y).
//!
//! Arcsine and arccosine are a polynomial up to 1/2, and from there on asin x = π/2 − 2·asin √((1 − x)/2).

use super::RawBits as _;
use super::pair::{LEADING, Pair, UPPER, ordered_sum, quotient};
use super::tables::{
    ARCSINE_POLYNOMIAL, ARCTANGENT_POLYNOMIAL, ARCTANGENT_ROWS, HALF_PI_HIGH, HALF_PI_LOW,
    WHOLE_PI_HIGH, WHOLE_PI_LOW,
};
use crate::prelude::*;

/// Coefficient of x³ in the Taylor series of the arctangent. Up to |x| = 1/32 the omitted terms are below 2⁻⁵³ of it.
#[crate::data]
const A3: f64 = -1.0 / 3.0;
/// Coefficient of x⁵.
#[crate::data]
const A5: f64 = 1.0 / 5.0;
/// Coefficient of x⁷.
#[crate::data]
const A7: f64 = -1.0 / 7.0;
/// Coefficient of x⁹.
#[crate::data]
const A9: f64 = 1.0 / 9.0;

/// The row for a ratio: 0 to 63 from 1/16 to 16, more outside.
#[inline]
#[function]
fn row_of_ratio(ratio: f64) -> u32 {
    // The exponent and three bits more, less those of 1/16.
    ((ratio.raw_bits() >> 49) as u32).wrapping_sub(0x1fd8)
}

/// The arctangent of `t` minus `t`, for |t| ≤ 1/32.
#[inline]
#[function]
fn small_curve(t: f64) -> f64 {
    let z = t * t;
    t * z * (A3 + z * (A5 + z * (A7 + z * A9)))
}

/// The arctangent of `t` minus `t`, for |t| ≤ 1/16.
#[inline]
#[function]
fn curve(t: f64) -> f64 {
    let z = t * t;
    let upper =
        ARCTANGENT_POLYNOMIAL[3] + z * (ARCTANGENT_POLYNOMIAL[4] + z * ARCTANGENT_POLYNOMIAL[5]);
    t * z
        * (ARCTANGENT_POLYNOMIAL[0]
            + z * (ARCTANGENT_POLYNOMIAL[1] + z * (ARCTANGENT_POLYNOMIAL[2] + z * upper)))
}

/// The arctangent of 0 to 1/16, of 16 and more, and of NaN.
#[function]
pub fn far(size: f64) -> f64 {
    if size < 1.0 {
        size + curve(size)
    } else {
        let t = 1.0 / size;
        HALF_PI_HIGH + (HALF_PI_LOW - (t + curve(t)))
    }
}

/// Arctangent, rad; measured within 0.63 ulp. ±0 gives ±0, ±∞ gives ±π/2, NaN gives NaN.
#[function]
pub fn atan(x: f64) -> f64 {
    let size = x.abs();
    let row = row_of_ratio(size);
    let value = if row < 64 {
        let centre = ARCTANGENT_ROWS[row as usize][0];
        let t = (size - centre) / (1.0 + size * centre);
        let rest = ARCTANGENT_ROWS[row as usize][2] + (t + small_curve(t));
        ARCTANGENT_ROWS[row as usize][1] + rest
    } else {
        far(size)
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

/// Angle of a point in the first quadrant, as two doubles, from 0 to π/2 rad. `ratio` is `height`/`width`, and all are
/// from 2^−900 to 2^900.
#[inline]
#[function]
fn angle_of_ratio(height: f64, width: f64, ratio: f64) -> Pair {
    let row = row_of_ratio(ratio);
    if row < 64 {
        let centre = ARCTANGENT_ROWS[row as usize][0];
        let upper = f64::from_bits(width.raw_bits() & UPPER);
        let above = (height - centre * upper) - centre * (width - upper);
        let t = above / (width + centre * height);
        let rest = ARCTANGENT_ROWS[row as usize][2] + (t + small_curve(t));
        Pair { high: ARCTANGENT_ROWS[row as usize][1], low: rest }
    } else {
        far_angle(height, width, ratio)
    }
}

/// Angle of a point in the first quadrant, as two doubles, for a `ratio` below 1/16 or from 16 on.
#[function]
pub fn far_angle(height: f64, width: f64, ratio: f64) -> Pair {
    if ratio < 1.0 {
        let exact = quotient(Pair { high: height, low: 0.0 }, Pair { high: width, low: 0.0 });
        Pair { high: exact.high, low: exact.low + curve(exact.high) }
    } else {
        let t = width / height;
        Pair { high: HALF_PI_HIGH, low: HALF_PI_LOW - (t + curve(t)) }
    }
}

/// The angle as it is, or its supplement to π for a point on the left.
#[inline]
#[function]
fn angle_on_side(angle: Pair, left: bool) -> f64 {
    if left {
        let rest = ordered_sum(WHOLE_PI_HIGH, -angle.high);
        rest.high + (rest.low + (WHOLE_PI_LOW - angle.low))
    } else {
        angle.high + angle.low
    }
}

/// The angle of the point (`x`, `y`) in rad, outside the common path. This is for special values and for coordinates
/// that are very large, very small or of very different size.
#[function]
pub fn far_atan2(y: f64, x: f64) -> f64 {
    let width = x.abs();
    let height = y.abs();
    let left = 1.0_f64.copysign(x) < 0.0;
    if !(width <= f64::INFINITY && height <= f64::INFINITY) {
        return f64::NAN;
    }
    let angle = if width <= height && height <= width {
        // Both zero, both infinite, or on the diagonal.
        if width > 0.0 {
            Pair { high: 0.5 * HALF_PI_HIGH, low: 0.5 * HALF_PI_LOW }
        } else {
            Pair { high: 0.0, low: 0.0 }
        }
    } else if height > width * 1.152921504606847e18 {
        // From 2⁶⁰ on, the result no longer changes.
        Pair { high: HALF_PI_HIGH, low: HALF_PI_LOW }
    } else if width * 8.673617379884035e-19 > height {
        // By 2⁻⁶⁰ the smaller coordinate enters as it is.
        Pair { high: height / width, low: 0.0 }
    } else {
        // By 2^±600, so that no product leaves the range.
        let scale = if width > 1.0 { 2.409919865102884e-181 } else { 4.149515568880993e180 };
        angle_of_ratio(height * scale, width * scale, height / width)
    };
    let value = angle_on_side(angle, left);
    value.copysign(y)
}

/// The angle of the point (`x`, `y`) in rad, −π to π; measured within 0.62 ulp. ±0, ±∞ and NaN as
/// in C99, F.9.1.4.
#[function]
pub fn atan2(y: f64, x: f64) -> f64 {
    let width = x.abs();
    let height = y.abs();
    if width > 1e-150 && width < 1e150 && height > 1e-150 && height < 1e150 {
        let angle = angle_of_ratio(height, width, height / width);
        let value = angle_on_side(angle, x < 0.0);
        if y < 0.0 { -value } else { value }
    } else {
        far_atan2(y, x)
    }
}

/// The polynomial of the arcsine after its first coefficient a: asin √z = √z·(1 + z·(a + z·rest)), for z from 0 to 1/4.
#[inline]
#[function]
fn arcsine_rest(z: f64) -> f64 {
    let w = z * z;
    let v = w * w;
    let lower = (ARCSINE_POLYNOMIAL[1] + z * ARCSINE_POLYNOMIAL[2])
        + w * (ARCSINE_POLYNOMIAL[3] + z * ARCSINE_POLYNOMIAL[4]);
    let middle = (ARCSINE_POLYNOMIAL[5] + z * ARCSINE_POLYNOMIAL[6])
        + w * (ARCSINE_POLYNOMIAL[7] + z * ARCSINE_POLYNOMIAL[8]);
    let upper = (ARCSINE_POLYNOMIAL[9] + z * ARCSINE_POLYNOMIAL[10])
        + w * (ARCSINE_POLYNOMIAL[11] + z * ARCSINE_POLYNOMIAL[12]);
    lower + v * (middle + v * upper)
}

/// asin(x)/x − 1 for the square `z` of x, from 0 to 1/4.
#[inline]
#[function]
fn arcsine_curve(z: f64) -> f64 {
    z * (ARCSINE_POLYNOMIAL[0] + z * arcsine_rest(z))
}

/// Half an arccosine, in rad, as the sum of three terms.
#[crate::data]
struct HalfAngle {
    /// The rounded root r of (1 − x)/2.
    root: f64,
    /// a·r³, the second term of the arcsine of r.
    cubic: f64,
    /// The correction of the root and the further terms.
    low: f64,
}

/// Half the arccosine of `size`, for `size` from 1/2 to less than 1.
#[inline]
#[function]
fn half_arccosine(size: f64) -> HalfAngle {
    let z = 0.5 - 0.5 * size;
    let root = z.sqrt();
    // What the root is off by is (z − r²)/2r; half its last place, so that three bits of 1/r will do:
    // the bits of a number are nearly its logarithm.
    let leading = f64::from_bits(root.raw_bits() & LEADING);
    let left = (z - leading * leading) - (root - leading) * (root + leading);
    let upper = 0x7fde_6000_u32.wrapping_sub((root.raw_bits() >> 32) as u32);
    let reciprocal = f64::from_bits((upper as u64) << 32);
    let cube = root * z;
    HalfAngle {
        root,
        cubic: cube * ARCSINE_POLYNOMIAL[0],
        low: cube * (z * arcsine_rest(z)) + 0.5 * left * reciprocal,
    }
}

/// `angle` less twice `half`. The root and the cubic term leave it exactly: each difference is kept with its error.
#[inline]
#[function]
fn less_twice(angle: Pair, half: HalfAngle) -> f64 {
    let lead = angle.high - 2.0 * half.root;
    let lost = (angle.high - lead) - 2.0 * half.root;
    let value = lead - 2.0 * half.cubic;
    let rest = (lead - value) - 2.0 * half.cubic;
    value + (rest + (lost + (angle.low - 2.0 * half.low)))
}

/// 2⁻²⁷: a smaller number equals its arcsine to the last bit.
#[crate::data]
const TINY: f64 = 7.450580596923828e-9;

/// Arcsine of −1 to 1, rad; measured within 0.64 ulp. ±0 gives ±0; numbers outside and NaN give
/// NaN.
#[function]
pub fn asin(x: f64) -> f64 {
    let size = x.abs();
    if size < 0.5 {
        let z = x * x;
        return if size < TINY { x } else { x + x * arcsine_curve(z) };
    }
    if size < 1.0 {
        let right = Pair { high: HALF_PI_HIGH, low: HALF_PI_LOW };
        let value = less_twice(right, half_arccosine(size));
        if x < 0.0 { -value } else { value }
    } else if size <= 1.0 {
        HALF_PI_HIGH * x
    } else {
        f64::NAN
    }
}

/// Arccosine of −1 to 1, rad; measured within 0.65 ulp. 1 gives 0; numbers outside and NaN give
/// NaN.
#[function]
pub fn acos(x: f64) -> f64 {
    let size = x.abs();
    if size < 0.5 {
        let z = x * x;
        let lead = HALF_PI_HIGH - x;
        let lost = (HALF_PI_HIGH - lead) - x;
        return lead + (lost + (HALF_PI_LOW - x * arcsine_curve(z)));
    }
    if size < 1.0 {
        let half = half_arccosine(size);
        if x > 0.0 {
            2.0 * (half.root + (half.cubic + half.low))
        } else {
            less_twice(Pair { high: WHOLE_PI_HIGH, low: WHOLE_PI_LOW }, half)
        }
    } else if size <= 1.0 {
        if x > 0.0 { 0.0 } else { WHOLE_PI_HIGH }
    } else {
        f64::NAN
    }
}
