//! The inverse trigonometric functions, by way of the arctangent of a ratio from 0 to 1.
//!
//! The ratio, in two doubles, is brought within 1/64 of a multiple of 1/64 by
//! atan t = atan c + atan((t − c) / (1 + t·c)) with a table of atan c; then Gregory's series. What
//! leads to the ratio (quotients, 1 − x², roots) is in two doubles too.

use super::pair::{Pair, ordered_sum, product, quotient, root, sum};
use super::tables::{
    ARCTANGENT_HIGH, ARCTANGENT_LOW, HALF_PI_HIGH, HALF_PI_LOW, WHOLE_PI_HIGH, WHOLE_PI_LOW,
};
use crate::prelude::*;

const A3: f64 = -1.0 / 3.0;
const A5: f64 = 1.0 / 5.0;
const A7: f64 = -1.0 / 7.0;
const A9: f64 = 1.0 / 9.0;
const A11: f64 = -1.0 / 11.0;
const A13: f64 = 1.0 / 13.0;
const A15: f64 = -1.0 / 15.0;
const A17: f64 = 1.0 / 17.0;
const A19: f64 = -1.0 / 19.0;

/// Below this a number is its own arcsine and arctangent: 2⁻²⁷.
const TINY: f64 = 7.450580596923828e-9;

/// Arctangent of 0 to 1, rad.
#[function]
pub fn arctangent_of_ratio(high: f64, low: f64) -> Pair {
    if high < 0.125 {
        let z = high * high;
        let upper = A11 + z * (A13 + z * (A15 + z * (A17 + z * A19)));
        let tail = A3 + z * (A5 + z * (A7 + z * (A9 + z * upper)));
        Pair { high, low: low + high * z * tail }
    } else {
        // 1.5 · 2⁵² leaves the nearest integer in the last bits. A ratio is at most 1.
        let shifted = high * 64.0 + 6_755_399_441_055_744.0;
        let index = (shifted.to_bits() & 127).min(63) as usize;
        let centre = index as f64 * 0.015625;
        let t = ((high - centre) + low) / (1.0 + high * centre);
        let z = t * t;
        let near = t + t * z * (A3 + z * (A5 + z * A7));
        Pair { high: ARCTANGENT_HIGH[index], low: ARCTANGENT_LOW[index] + near }
    }
}

/// The angle of a point in the first quadrant, not at its corner, rad.
#[function]
pub fn first_quadrant(y: Pair, x: Pair) -> Pair {
    if y.high <= x.high {
        let ratio = quotient(y, x);
        arctangent_of_ratio(ratio.high, ratio.low)
    } else {
        let ratio = quotient(x, y);
        let from_vertical = arctangent_of_ratio(ratio.high, ratio.low);
        let angle = ordered_sum(HALF_PI_HIGH, -from_vertical.high);
        Pair { high: angle.high, low: angle.low + (HALF_PI_LOW - from_vertical.low) }
    }
}

/// π less an angle.
#[function]
pub fn supplement(angle: Pair) -> f64 {
    let rest = ordered_sum(WHOLE_PI_HIGH, -angle.high);
    rest.high + (rest.low + (WHOLE_PI_LOW - angle.low))
}

/// Arctangent, rad.
#[function]
pub fn atan(x: f64) -> f64 {
    let size = x.abs();
    if size < TINY {
        return x;
    }
    // From 2⁶⁰ on, the result no longer changes.
    if size > 1.152921504606847e18 {
        return HALF_PI_HIGH.copysign(x);
    }
    let one = Pair { high: 1.0, low: 0.0 };
    let angle = first_quadrant(Pair { high: size, low: 0.0 }, one);
    let value = angle.high + angle.low;
    if x < 0.0 { -value } else { value }
}

/// The angle of the point (`x`, `y`) in rad, −π to π; special values as C99 Annex F has them.
#[function]
pub fn atan2(y: f64, x: f64) -> f64 {
    // 2³⁰: from this ratio on, the smaller coordinate enters as it is.
    const FAR: f64 = 1_073_741_824.0;
    let width = x.abs();
    let height = y.abs();
    let left = 1.0_f64.copysign(x) < 0.0;
    let both = width == height && (width == 0.0 || width > f64::MAX);
    let angle = if both {
        // Both zero or both infinite.
        if width == 0.0 {
            Pair { high: 0.0, low: 0.0 }
        } else {
            Pair { high: 0.5 * HALF_PI_HIGH, low: 0.5 * HALF_PI_LOW }
        }
    } else if width * 9.313225746154785e-10 > height {
        Pair { high: height / width, low: 0.0 }
    } else if height * 9.313225746154785e-10 > width {
        let ratio = width / height;
        Pair { high: HALF_PI_HIGH, low: HALF_PI_LOW - ratio }
    } else {
        // By 2^±600, so that no product leaves the range.
        let scale = if width > FAR { 2.409919865102884e-181 } else { 4.149515568880993e180 };
        let above = Pair { high: height * scale, low: 0.0 };
        first_quadrant(above, Pair { high: width * scale, low: 0.0 })
    };
    let value = if left { supplement(angle) } else { angle.high + angle.low };
    value.copysign(y)
}

/// The cosine of the arcsine: √(1 − x²) for −1 to 1.
#[function]
pub fn complement(x: f64) -> Pair {
    let square = product(x, x);
    let lead = sum(1.0, -square.high);
    root(ordered_sum(lead.high, lead.low - square.low))
}

/// Arcsine, rad.
#[function]
pub fn asin(x: f64) -> f64 {
    let size = x.abs();
    if size < TINY {
        return x;
    }
    if size <= 1.0 {
        let angle = first_quadrant(Pair { high: size, low: 0.0 }, complement(size));
        let value = angle.high + angle.low;
        if x < 0.0 { -value } else { value }
    } else {
        f64::NAN
    }
}

/// Arccosine, rad.
#[function]
pub fn acos(x: f64) -> f64 {
    let size = x.abs();
    if size <= 1.0 {
        let angle = first_quadrant(complement(size), Pair { high: size, low: 0.0 });
        if x < 0.0 { supplement(angle) } else { angle.high + angle.low }
    } else {
        f64::NAN
    }
}
