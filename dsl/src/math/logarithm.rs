//! The logarithms.
//!
//! After P. T. P. Tang, *Table-driven implementation of the logarithm function in IEEE floating-point
//! arithmetic* (ACM TOMS 16, 1990), with reciprocals in place of its division: x = 2^k · m, and c a
//! reciprocal of m to 12 bits from a table, so that r = m·c − 1 comes out exactly, in two parts.
//! Then ln x = k · ln 2 − ln c + ln(1 + r), the last from Mercator's series; the sum is kept in two
//! doubles, of some 66 bits.

use super::pair::{Pair, ordered_sum, pair_product, sum};
use super::tables::{
    LN_2_HIGH, LN_2_LOW, LOGARITHM_HIGH, LOGARITHM_LOW, RECIPROCAL, RECIPROCAL_LN_2_HIGH,
    RECIPROCAL_LN_2_LOW, RECIPROCAL_LN_10_HIGH, RECIPROCAL_LN_10_LOW,
};
use crate::prelude::*;

const L3: f64 = 1.0 / 3.0;
const L4: f64 = -1.0 / 4.0;
const L5: f64 = 1.0 / 5.0;
const L6: f64 = -1.0 / 6.0;
const L7: f64 = 1.0 / 7.0;
const L8: f64 = -1.0 / 8.0;
const L9: f64 = 1.0 / 9.0;

/// ln x of a finite x above zero, before its last rounding.
#[function]
pub fn logarithm(x: f64) -> Pair {
    // By 2⁵⁴ below the normal numbers.
    let subnormal = x < f64::MIN_POSITIVE;
    let bits = if subnormal { (x * 18_014_398_509_481_984.0).to_bits() } else { x.to_bits() };
    let bias = if subnormal { 1023.0 + 54.0 } else { 1023.0 };
    let exponent = ((bits >> 52) & 0x7ff) as u32 as f64 - bias;
    let significand = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000);
    let upper = significand > core::f64::consts::SQRT_2;
    let mantissa = if upper { 0.5 * significand } else { significand };
    let turns = if upper { exponent + 1.0 } else { exponent };

    // 1.5 · 2⁵² leaves the nearest integer in the last bits.
    let index = ((mantissa * 128.0 + 6_755_399_441_055_744.0).to_bits() & 127) as usize;
    let reciprocal = RECIPROCAL[index];
    // To the nearest: next to 1 the coarse part alone is 1.
    let nearest = mantissa.to_bits().wrapping_add(0x4000_0000);
    let coarse = f64::from_bits(nearest & 0xffff_ffff_8000_0000);
    let r_high = coarse * reciprocal - 1.0;
    let r_low = (mantissa - coarse) * reciprocal;
    let r = r_high + r_low;
    let tail = L3 + r * (L4 + r * (L5 + r * (L6 + r * (L7 + r * (L8 + r * L9)))));

    // The first sum and the square of r_high are exact.
    let lead = ordered_sum(turns * LN_2_HIGH + LOGARITHM_HIGH[index] + r_high, r_low);
    let next = ordered_sum(lead.high, -0.5 * r_high * r_high);
    let cross = r_low * (r_high + 0.5 * r_low);
    let small = (r * r * r * tail - cross) + (LOGARITHM_LOW[index] + turns * LN_2_LOW);
    ordered_sum(next.high, (next.low + lead.low) + small)
}

/// The logarithm where its argument is zero, negative, infinite or NaN.
#[function]
pub fn logarithm_at_limit(x: f64) -> f64 {
    if x == 0.0 {
        -f64::INFINITY
    } else if x > 0.0 {
        f64::INFINITY
    } else {
        f64::NAN
    }
}

/// The natural logarithm.
#[function]
pub fn ln(x: f64) -> f64 {
    if x > 0.0 && x <= f64::MAX { logarithm(x).high } else { logarithm_at_limit(x) }
}

/// The logarithm to base 2.
#[function]
pub fn log2(x: f64) -> f64 {
    if x > 0.0 && x <= f64::MAX {
        let unit = Pair { high: RECIPROCAL_LN_2_HIGH, low: RECIPROCAL_LN_2_LOW };
        pair_product(logarithm(x), unit).high
    } else {
        logarithm_at_limit(x)
    }
}

/// The logarithm to base 10.
#[function]
pub fn log10(x: f64) -> f64 {
    if x > 0.0 && x <= f64::MAX {
        let unit = Pair { high: RECIPROCAL_LN_10_HIGH, low: RECIPROCAL_LN_10_LOW };
        pair_product(logarithm(x), unit).high
    } else {
        logarithm_at_limit(x)
    }
}

/// ln(1 + x), without cancellation.
#[function]
pub fn ln_1p(x: f64) -> f64 {
    if x > -1.0 && x <= f64::MAX {
        // 2⁻⁵⁴
        if x.abs() < 5.551115123125783e-17 {
            return x;
        }
        // What 1 + x loses comes back at first order.
        let whole = sum(1.0, x);
        let result = logarithm(whole.high);
        result.high + (result.low + whole.low / whole.high)
    } else {
        logarithm_at_limit(1.0 + x)
    }
}
