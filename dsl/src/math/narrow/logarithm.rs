//! The logarithms.
//!
//! Natural logarithm and base 2: a significand is c · (1 + r), with c and its logarithm from a table; a short
//! polynomial is for r (P. T. P. Tang). The leading parts of the logarithms of c have so few bits that their sums
//! with the exponent's part are exact.
//!
//! ln(1 + x) and base 10: with f = m − 1 of a significand m from 0.705 to 1.410 and s = f/(2 + f), ln m is the series
//! of 2 artanh s, written as f − f²/2 + s · (f²/2 + R(s²)) so that the large terms are exact.

use super::super::RawBits as _;
use super::super::tables::{
    NARROW_BINARY_LOG, NARROW_BINARY_LOG_ROWS, NARROW_LN, NARROW_LN_2_HIGH, NARROW_LN_2_LOW,
    NARROW_LN_ROWS, NARROW_LOG10_2_HIGH, NARROW_LOG10_2_LOW, NARROW_LOG10_E_HIGH,
    NARROW_LOG10_E_LOW, NARROW_LOGARITHM,
};
use super::{PairF32, leading, ordered_sum};
use crate::prelude::*;

/// A positive number as 2^`exponent` · (1 + `rest`), with `rest` from −0.295 to 0.410.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SplitF32 {
    /// The exponent.
    pub exponent: f32,
    /// The significand minus 1: exact.
    pub rest: f32,
}

/// The parts of a normal number; `less` is subtracted from its exponent.
#[inline]
#[function]
fn split(x: f32, less: i32) -> SplitF32 {
    let bits = x.raw_bits();
    // Above 1 + 52.5/128 a significand is halved.
    let exponent = bits.wrapping_sub(0x3f34_8000) as i32 >> 23;
    SplitF32 {
        exponent: exponent.wrapping_sub(less) as f32,
        rest: f32::from_bits(bits.wrapping_sub((exponent as u32) << 23)) - 1.0,
    }
}

/// s · (f²/2 + R(s²)), where `half` is f²/2.
#[inline]
#[function]
fn beyond_square(f: f32, half: f32) -> f32 {
    let s = f / (2.0 + f);
    let z = s * s;
    let tail = z * (NARROW_LOGARITHM[0] + z * (NARROW_LOGARITHM[1] + z * NARROW_LOGARITHM[2]));
    s * (half + tail)
}

/// The natural logarithm of 2^`exponent` · (1 + `rest`), plus the correction `lost`.
#[inline]
#[function]
fn natural(parts: SplitF32, lost: f32) -> f32 {
    let f = parts.rest;
    let half = 0.5 * f * f;
    let lead = ordered_sum(parts.exponent * NARROW_LN_2_HIGH, f);
    let small = (beyond_square(f, half) + (lost + parts.exponent * NARROW_LN_2_LOW)) + lead.low;
    lead.high + (small - half)
}

/// ln(1 + `f`) as a sum of two floats, the first of 12 bits.
#[inline]
#[function]
fn natural_pair(f: f32) -> PairF32 {
    let half = 0.5 * f * f;
    let high = leading(f - half);
    PairF32 { high, low: ((f - high) - half) + beyond_square(f, half) }
}

/// Returns true if a number is positive, normal and finite.
#[inline]
#[function]
pub(crate) fn is_plain(x: f32) -> bool {
    x.raw_bits().wrapping_sub(0x0080_0000) < 0x7f00_0000
}

/// Logarithms of numbers that are not positive and normal.
#[inline]
#[function]
fn limit(x: f32) -> f32 {
    if x.abs() <= 0.0 {
        f32::NEG_INFINITY
    } else if x > 0.0 {
        x
    } else {
        f32::NAN
    }
}

/// Returns true if a number is positive and subnormal.
#[inline]
#[function]
pub(crate) fn is_subnormal(x: f32) -> bool {
    x > 0.0 && x < f32::MIN_POSITIVE
}

/// A positive number as 2^`exponent` · `significand`, with the significand from 0.703 to 1.406.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowF32 {
    /// The exponent.
    pub exponent: f32,
    /// The significand.
    pub significand: f32,
    /// The row of the significand in the table; only the last six bits count.
    pub row: u32,
}

/// The parts of a normal number; `less` is subtracted from its exponent.
#[inline]
#[function]
fn row_of(x: f32, less: i32) -> RowF32 {
    let bits = x.raw_bits();
    // Next to 1 ± 1/64, rows end where a logarithm to base e is a power of two.
    let above = bits.wrapping_sub(0x3f34_0600);
    RowF32 {
        exponent: (above as i32 >> 23).wrapping_sub(less) as f32,
        significand: f32::from_bits(bits.wrapping_sub(above & 0xff80_0000)),
        row: above >> 17,
    }
}

/// The natural logarithm of the parts of a number.
#[inline]
#[function]
fn natural_of_row(parts: RowF32) -> f32 {
    let row = (parts.row & 63) as usize;
    let r = (parts.significand - NARROW_LN_ROWS[row][0]) * NARROW_LN_ROWS[row][1];
    let z = r * r;
    let curve = z * ((NARROW_LN[0] + r * NARROW_LN[1]) + z * NARROW_LN[2]);
    let rest = parts.exponent * NARROW_LN_2_LOW + NARROW_LN_ROWS[row][3];
    (parts.exponent * NARROW_LN_2_HIGH + NARROW_LN_ROWS[row][2]) + (r + (rest + curve))
}

/// The natural logarithm of a number that is not positive and normal.
#[function]
pub fn far_lnf(x: f32) -> f32 {
    if is_subnormal(x) { natural_of_row(row_of(x * 8_388_608.0, 23)) } else { limit(x) }
}

/// The natural logarithm; within 1 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and NaN give NaN.
#[function]
pub fn lnf(x: f32) -> f32 {
    if is_plain(x) { natural_of_row(row_of(x, 0)) } else { far_lnf(x) }
}

/// ln(1 + x), without cancellation; within 1 ulp. ±0 gives ±0, −1 gives −∞, ∞ gives ∞; numbers
/// below −1 and NaN give NaN.
#[function]
pub fn ln_1pf(x: f32) -> f32 {
    if x.abs() < 0.29 {
        if x.abs() < 5.9604645e-8 {
            // −0 stays what it is.
            return x;
        }
        return natural(SplitF32 { exponent: 0.0, rest: x }, 0.0);
    }
    let sum = 1.0 + x;
    if is_plain(sum) {
        let lost = if x < 1.0 { x - (sum - 1.0) } else { 1.0 - (sum - x) };
        natural(split(sum, 0), lost / sum)
    } else {
        limit(sum)
    }
}

/// The logarithm to base 2 of the parts of a number.
#[inline]
#[function]
fn binary_of_row(parts: RowF32) -> f32 {
    let row = (parts.row & 63) as usize;
    let r = (parts.significand - NARROW_BINARY_LOG_ROWS[row][0]) * NARROW_BINARY_LOG_ROWS[row][1];
    // Of log₂ e = 1.4427, 1 + 7/16 is taken by itself: next to 1, r has so few bits that this product is exact.
    let upper = NARROW_BINARY_LOG[2] + r * NARROW_BINARY_LOG[3];
    let curve = r * (NARROW_BINARY_LOG[0] + r * (NARROW_BINARY_LOG[1] + r * upper));
    let rest = 0.4375 * r + NARROW_BINARY_LOG_ROWS[row][3];
    (parts.exponent + NARROW_BINARY_LOG_ROWS[row][2]) + (r + (rest + curve))
}

/// The logarithm to base 2 of a number that is not positive and normal.
#[function]
pub fn far_log2f(x: f32) -> f32 {
    if is_subnormal(x) { binary_of_row(row_of(x * 8_388_608.0, 23)) } else { limit(x) }
}

/// The logarithm to base 2; within 1 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and NaN give
/// NaN.
#[function]
pub fn log2f(x: f32) -> f32 {
    if is_plain(x) { binary_of_row(row_of(x, 0)) } else { far_log2f(x) }
}

/// The logarithm to base 10 of the parts of a number.
#[inline]
#[function]
fn decimal(parts: SplitF32) -> f32 {
    let ln = natural_pair(parts.rest);
    let lead = ordered_sum(parts.exponent * NARROW_LOG10_2_HIGH, ln.high * NARROW_LOG10_E_HIGH);
    let small = (ln.high + ln.low) * NARROW_LOG10_E_LOW + ln.low * NARROW_LOG10_E_HIGH;
    lead.high + (lead.low + (small + parts.exponent * NARROW_LOG10_2_LOW))
}

/// The logarithm to base 10; within 1 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and NaN give
/// NaN.
#[function]
pub fn log10f(x: f32) -> f32 {
    if is_plain(x) {
        decimal(split(x, 0))
    } else if is_subnormal(x) {
        decimal(split(x * 8_388_608.0, 23))
    } else {
        limit(x)
    }
}
