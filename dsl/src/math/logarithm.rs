//! The logarithms.
//!
//! After P. T. P. Tang, *Table-driven implementation of the logarithm function in IEEE floating-point arithmetic*
//! (ACM TOMS 16, 1990): x = 2^k · m with m around 1, and a c near m from a table with 1/c and its logarithm. Then m −
//! c is exact, and with r = (m − c)/c, ln x = k · ln 2 + ln c + ln(1 + r), the last from a polynomial. Each c is
//! chosen so that ln c is very nearly a double (S. Gal, *Computing elementary functions*, 1986). So k · ln 2 + ln c
//! is exact except for the error of the leading part of ln 2, and one sum rounds.
//!
//! From 15/16 to 17/16 that would lose too much: there ln(1 + r) is r − r²/2 in two doubles and a longer polynomial.
//! A power needs more precision everywhere: [`logarithm`] is in two doubles, with c whose reciprocals have so few
//! bits that r is exact.

use super::RawBits as _;
use super::pair::{LEADING, Pair, UPPER, ordered_sum, sum};
use super::tables::{
    COARSE_REST, COARSE_ROWS, FINER_LN, LN_2_HIGH, LN_2_LOW, LN_CENTRES, LN_NEAR_ONE,
    LN_POLYNOMIAL, LN_ROWS, LOG2_CENTRES, LOG2_E_HIGH, LOG2_E_LOW, LOG2_POLYNOMIAL, LOG2_ROWS,
    LOG10_2_HIGH, LOG10_2_LOW, LOG10_CENTRES, LOG10_E_HIGH, LOG10_E_LOW, LOG10_POLYNOMIAL,
    LOG10_ROWS,
};
use crate::prelude::*;

/// Numbers within this distance of 1 have the longer polynomial.
#[crate::data]
const NEAR: f64 = 0.0625;

/// A positive number as 2^`exponent` · `significand`, with the significand from 0.705 to 1.410.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// The exponent.
    pub exponent: i32,
    /// The row of the tables.
    pub row: usize,
    /// The significand.
    pub significand: f64,
}

/// The parts of a normal number, given its bits.
#[inline]
#[function]
pub(crate) fn parts(bits: u64) -> Parts {
    // Above 1 + 52.5/128 a significand is halved.
    let above = ((bits >> 32) as u32).wrapping_sub(0x3fe6_9000);
    let exponent = above as i32 >> 20;
    Parts {
        exponent,
        row: ((above >> 13) & 127) as usize,
        significand: f64::from_bits(bits.wrapping_sub((exponent as u32 as u64) << 52)),
    }
}

/// Returns true if the bits are those of a positive, normal and finite number.
#[inline]
#[function]
pub(crate) fn is_plain(bits: u64) -> bool {
    ((bits >> 32) as u32).wrapping_sub(0x0010_0000) < 0x7fe0_0000
}

/// The bits of a positive number; a subnormal number is multiplied by 2⁵⁴ first.
#[inline]
#[function]
fn normal_bits(x: f64) -> u64 {
    if x < f64::MIN_POSITIVE { (x * 18_014_398_509_481_984.0).raw_bits() } else { x.raw_bits() }
}

/// ln(1 + `r`) for r from −1/16 to 1/16, as two summands: r − r²/2 rounded, and the rest.
#[function]
pub fn ln_near_one(r: f64) -> Pair {
    let z = r * r;
    let w = z * z;
    let lower = (LN_NEAR_ONE[0] + r * LN_NEAR_ONE[1]) + z * (LN_NEAR_ONE[2] + r * LN_NEAR_ONE[3]);
    let middle = (LN_NEAR_ONE[4] + r * LN_NEAR_ONE[5]) + z * (LN_NEAR_ONE[6] + r * LN_NEAR_ONE[7]);
    let upper = (LN_NEAR_ONE[8] + r * LN_NEAR_ONE[9]) + z * LN_NEAR_ONE[10];
    let tail = r * z * (lower + w * (middle + w * upper));
    let leading = f64::from_bits(r.raw_bits() & LEADING);
    let half_square = 0.5 * leading * leading;
    let high = r - half_square;
    let lost = (r - high) - half_square;
    let cross = 0.5 * (r - leading) * (r + leading);
    Pair { high, low: lost + (tail - cross) }
}

/// Difference of the significand from its c in the table of natural logarithms; exact.
#[inline]
#[function]
fn offset(parts: Parts) -> f64 {
    parts.significand - LN_CENTRES[parts.row & 127]
}

/// The natural logarithm of 2^`exponent` · (c + `offset`) for the c of `row`; the number must not be near 1.
#[inline]
#[function]
fn ln_of_offset(row: usize, exponent: f64, offset: f64) -> f64 {
    let r = offset * LN_ROWS[row & 127][0];
    let z = r * r;
    let tail =
        (LN_POLYNOMIAL[0] + r * LN_POLYNOMIAL[1]) + z * (LN_POLYNOMIAL[2] + r * LN_POLYNOMIAL[3]);
    let lead = exponent * LN_2_HIGH + LN_ROWS[row & 127][1];
    lead + (r + (z * (r * tail - 0.5) + exponent * LN_2_LOW))
}

/// The logarithm of zero, negative numbers, infinity and NaN.
#[function]
pub fn at_limit(x: f64) -> f64 {
    if x.abs() <= 0.0 {
        -f64::INFINITY
    } else if x > 0.0 {
        f64::INFINITY
    } else {
        f64::NAN
    }
}

/// Returns true if a number is positive and subnormal.
#[inline]
#[function]
fn is_small(x: f64) -> bool {
    x > 0.0 && x < f64::MIN_POSITIVE
}

/// The natural logarithm; measured within 0.57 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn ln(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let r = x - 1.0;
        if r.abs() < NEAR {
            let near = ln_near_one(r);
            return near.high + near.low;
        }
        let parts = parts(bits);
        ln_of_offset(parts.row, parts.exponent as f64, offset(parts))
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        ln_of_offset(parts.row, parts.exponent as f64 - 54.0, offset(parts))
    } else {
        at_limit(x)
    }
}

/// ln(1 + `r`) for a small `r`, times the logarithm of e to another base: its leading 31 bits and the rest.
#[function]
pub fn near_one_in_base(r: f64, e_high: f64, e_low: f64) -> f64 {
    let near = ln_near_one(r);
    // 21 bits times 31: exact.
    let upper = f64::from_bits(near.high.raw_bits() & UPPER);
    let rest = (near.high - upper) + near.low;
    upper * e_high + (rest * (e_high + e_low) + upper * e_low)
}

/// The logarithm to base 2 of 2^`exponent` · `parts`, which must not be near 1.
#[inline]
#[function]
fn log2_of_parts(parts: Parts, exponent: f64) -> f64 {
    let row = parts.row & 127;
    let r = (parts.significand - LOG2_CENTRES[row]) * LOG2_ROWS[row][0];
    let z = r * r;
    let upper = (LOG2_POLYNOMIAL[2] + r * LOG2_POLYNOMIAL[3])
        + z * (LOG2_POLYNOMIAL[4] + r * LOG2_POLYNOMIAL[5]);
    let tail = (LOG2_POLYNOMIAL[0] + r * LOG2_POLYNOMIAL[1]) + z * upper;
    (exponent + LOG2_ROWS[row][1]) + r * tail
}

/// The logarithm to base 2; measured within 0.63 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn log2(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let r = x - 1.0;
        if r.abs() < NEAR {
            return near_one_in_base(r, LOG2_E_HIGH, LOG2_E_LOW);
        }
        let parts = parts(bits);
        log2_of_parts(parts, parts.exponent as f64)
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        log2_of_parts(parts, parts.exponent as f64 - 54.0)
    } else {
        at_limit(x)
    }
}

/// The logarithm to base 10 of 2^`exponent` · `parts`, which must not be near 1.
#[inline]
#[function]
fn log10_of_parts(parts: Parts, exponent: f64) -> f64 {
    let row = parts.row & 127;
    let r = (parts.significand - LOG10_CENTRES[row]) * LOG10_ROWS[row][0];
    let z = r * r;
    let upper = (LOG10_POLYNOMIAL[2] + r * LOG10_POLYNOMIAL[3])
        + z * (LOG10_POLYNOMIAL[4] + r * LOG10_POLYNOMIAL[5]);
    let tail = (LOG10_POLYNOMIAL[0] + r * LOG10_POLYNOMIAL[1]) + z * upper;
    let lead = exponent * LOG10_2_HIGH + LOG10_ROWS[row][1];
    lead + (r * tail + exponent * LOG10_2_LOW)
}

/// The logarithm to base 10; measured within 0.68 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn log10(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let r = x - 1.0;
        if r.abs() < NEAR {
            return near_one_in_base(r, LOG10_E_HIGH, LOG10_E_LOW);
        }
        let parts = parts(bits);
        log10_of_parts(parts, parts.exponent as f64)
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        log10_of_parts(parts, parts.exponent as f64 - 54.0)
    } else {
        at_limit(x)
    }
}

/// ln(1 + x), without cancellation; measured within 0.57 ulp. ±0 gives ±0, −1 gives −∞, ∞ gives ∞;
/// numbers below −1 and NaN give NaN.
#[function]
pub fn ln_1p(x: f64) -> f64 {
    // From 2⁻⁵⁴ to 2⁶⁰: below, it is x itself, above, the one is lost.
    let exponent = ((x.raw_bits() >> 32) as u32 & 0x7fff_ffff).wrapping_sub(0x3c90_0000);
    if exponent < 0x0720_0000 && x > -1.0 {
        if x.abs() < NEAR {
            let near = ln_near_one(x);
            return near.high + near.low;
        }
        let whole = sum(1.0, x);
        let parts = parts(whole.high.raw_bits());
        let scale = f64::from_bits((1023_i32.wrapping_sub(parts.exponent) as u32 as u64) << 52);
        let offset = offset(parts) + whole.low * scale;
        ln_of_offset(parts.row, parts.exponent as f64, offset)
    } else {
        far_ln_1p(x)
    }
}

/// ln(1 + x) for an x that is nearly zero, huge, or out of range.
#[function]
pub fn far_ln_1p(x: f64) -> f64 {
    if x.abs() < 0.5 { x } else { ln(1.0 + x) }
}

/// ln x of 2^`exponent` · `parts`, as a sum of two doubles that may overlap, to about 68 bits.
#[inline]
#[function]
pub(crate) fn logarithm(parts: Parts, exponent: f64) -> Pair {
    let row = parts.row & 127;
    let reciprocal = COARSE_ROWS[row][0];
    // To the nearest: next to 1 the coarse part alone is 1.
    let bits = parts.significand.raw_bits();
    let coarse = f64::from_bits(bits.wrapping_add(0x8000_0000) & UPPER);
    let r_high = coarse * reciprocal - 1.0;
    let r_low = (parts.significand - coarse) * reciprocal;
    // Exact, as are both parts, the first sum, and the square of r_high.
    let r = r_high + r_low;
    let start = exponent * LN_2_HIGH + COARSE_ROWS[row][1];
    let lead = ordered_sum(start, r);
    let half = 0.5 * r_high;
    let next = ordered_sum(lead.high, -half * r_high);
    let cross = r_low * (half + 0.5 * r);
    let rest = COARSE_REST[row] + exponent * LN_2_LOW;

    let z = r * r;
    let upper = (FINER_LN[4] + r * FINER_LN[5]) + z * FINER_LN[6];
    let tail = (FINER_LN[0] + r * FINER_LN[1]) + z * ((FINER_LN[2] + r * FINER_LN[3]) + z * upper);
    Pair { high: next.high, low: r * z * tail + ((rest + lead.low) + (next.low - cross)) }
}
