//! The logarithms.
//!
//! After P. T. P. Tang, *Table-driven implementation of the logarithm function in IEEE floating-point
//! arithmetic* (ACM TOMS 16, 1990), with reciprocals in place of its division: x = 2^k · m with m
//! around 1, and c near 1/m from a table. The upper 21 bits of m times the 32 bits of c come out
//! exactly, so r = m·c − 1 is exact in two parts. Then ln x = k · ln 2 − ln c + ln(1 + r), the last from
//! a polynomial. The c are chosen so that −ln c fits in a double with nothing left over. [`powf`]
//! needs more: the logarithm in two doubles, [`logarithm`], from coarser c.
//!
//! [`powf`]: super::power::powf

use core::f64::consts::{LOG2_E, LOG10_E};

use super::RawBits as _;
use super::pair::{Pair, ordered_sum, sum};
use super::tables::{
    COARSE_REST, COARSE_ROWS, LN, LN_2_HIGH, LN_2_LOW, LN_ROWS, LOG2_ROWS, LOG10_2_HIGH,
    LOG10_2_LOW, LOG10_ROWS, RECIPROCAL_LN_2_HIGH, RECIPROCAL_LN_2_LOW, RECIPROCAL_LN_10_HIGH,
    RECIPROCAL_LN_10_LOW,
};
use crate::prelude::*;

const L3: f64 = 1.0 / 3.0;
const L4: f64 = -1.0 / 4.0;
const L5: f64 = 1.0 / 5.0;
const L6: f64 = -1.0 / 6.0;
const L7: f64 = 1.0 / 7.0;
const L8: f64 = -1.0 / 8.0;
const L9: f64 = 1.0 / 9.0;

/// The upper half of a double.
const UPPER: u64 = 0xffff_ffff_0000_0000;

/// A positive number as 2^`exponent` · (`coarse` + `fine`) with that between 0.707 and 1.414.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// The exponent.
    pub exponent: i32,
    /// The first seven bits of the significand behind its leading one.
    pub row: usize,
    /// The significand, to 21 bits.
    pub coarse: f64,
    /// The rest of it.
    pub fine: f64,
}

/// The parts of a normal number, from its bits.
#[inline]
#[function]
pub fn parts(bits: u64) -> Parts {
    // Above 1 + 53/128 a significand is halved.
    let above = ((bits >> 32) as u32).wrapping_sub(0x3fe6_a000);
    let exponent = above as i32 >> 20;
    let significand = bits.wrapping_sub((exponent as u32 as u64) << 52);
    // To the nearest: next to 1 the coarse part alone is 1.
    let coarse = f64::from_bits(significand.wrapping_add(0x8000_0000) & UPPER);
    Parts {
        exponent,
        row: ((bits >> 45) & 127) as usize,
        coarse,
        fine: f64::from_bits(significand) - coarse,
    }
}

/// Whether a number is positive, normal and finite, from its bits.
#[inline]
#[function]
pub fn is_plain(bits: u64) -> bool {
    ((bits >> 32) as u32).wrapping_sub(0x0010_0000) < 0x7fe0_0000
}

/// The bits of a positive number, of one below the normal ones times 2⁵⁴.
#[inline]
#[function]
pub fn normal_bits(x: f64) -> u64 {
    if x < f64::MIN_POSITIVE { (x * 18_014_398_509_481_984.0).raw_bits() } else { x.raw_bits() }
}

/// (ln(1 + r) − r)/r².
#[inline]
#[function]
pub fn curve(r: f64) -> f64 {
    let z = r * r;
    r * ((LN[0] + r * LN[1]) + z * ((LN[2] + r * LN[3]) + z * LN[4])) - 0.5
}

/// The natural logarithm of 2^`exponent` · `parts`.
#[inline]
#[function]
pub fn ln_of_parts(parts: Parts, exponent: f64) -> f64 {
    let reciprocal = LN_ROWS[parts.row & 127][0];
    let r_high = parts.coarse * reciprocal - 1.0;
    let r_low = parts.fine * reciprocal;
    let r = r_high + r_low;
    let row = exponent * LN_2_HIGH + LN_ROWS[parts.row & 127][1];
    let lead = row + r;
    let low = (((row - lead) + r) + ((r_high - r) + r_low)) + exponent * LN_2_LOW;
    lead + (low + r * r * curve(r))
}

/// A row of a table.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// c, near the reciprocal of a significand.
    pub reciprocal: f64,
    /// Minus its logarithm.
    pub logarithm: f64,
}

/// What turns natural logarithms into those of a base.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Base {
    /// One by the natural logarithm of the base, to 31 bits.
    pub unit: f64,
    /// What `unit` leaves out.
    pub unit_low: f64,
    /// Both together.
    pub whole: f64,
    /// The logarithm of 2 to the base, to few bits.
    pub two: f64,
    /// What `two` leaves out.
    pub two_low: f64,
}

/// The logarithm of 2^`exponent` · `parts` to another base.
#[inline]
#[function]
pub fn log_of_parts(parts: Parts, exponent: f64, row: Row, base: Base) -> f64 {
    let r_high = parts.coarse * row.reciprocal - 1.0;
    let r_low = parts.fine * row.reciprocal;
    let r = r_high + r_low;
    let upper = f64::from_bits(r.raw_bits() & UPPER);
    let rest = (r_high - upper) + r_low;
    let start = exponent * base.two + row.logarithm;
    // Exact: 21 bits times 31.
    let step = upper * base.unit;
    let lead = start + step;
    let low = ((start - lead) + step) + exponent * base.two_low;
    let tail = rest * base.unit + r * base.unit_low;
    lead + (low + (tail + r * r * curve(r) * base.whole))
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

/// Whether a number is below the normal ones, and above zero.
#[inline]
#[function]
pub fn is_small(x: f64) -> bool {
    x > 0.0 && x < f64::MIN_POSITIVE
}

/// The natural logarithm.
#[function]
pub fn ln(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let parts = parts(bits);
        ln_of_parts(parts, parts.exponent as f64)
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        ln_of_parts(parts, parts.exponent as f64 - 54.0)
    } else {
        logarithm_at_limit(x)
    }
}

/// The logarithm to base 2 of 2^`exponent` · `parts`.
#[inline]
#[function]
pub fn log2_of_parts(parts: Parts, exponent: f64) -> f64 {
    let row =
        Row { reciprocal: LOG2_ROWS[parts.row & 127][0], logarithm: LOG2_ROWS[parts.row & 127][1] };
    let base = Base {
        unit: RECIPROCAL_LN_2_HIGH,
        unit_low: RECIPROCAL_LN_2_LOW,
        whole: LOG2_E,
        two: 1.0,
        two_low: 0.0,
    };
    log_of_parts(parts, exponent, row, base)
}

/// The logarithm to base 2.
#[function]
pub fn log2(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let parts = parts(bits);
        log2_of_parts(parts, parts.exponent as f64)
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        log2_of_parts(parts, parts.exponent as f64 - 54.0)
    } else {
        logarithm_at_limit(x)
    }
}

/// The logarithm to base 10 of 2^`exponent` · `parts`.
#[inline]
#[function]
pub fn log10_of_parts(parts: Parts, exponent: f64) -> f64 {
    let row = Row {
        reciprocal: LOG10_ROWS[parts.row & 127][0],
        logarithm: LOG10_ROWS[parts.row & 127][1],
    };
    let base = Base {
        unit: RECIPROCAL_LN_10_HIGH,
        unit_low: RECIPROCAL_LN_10_LOW,
        whole: LOG10_E,
        two: LOG10_2_HIGH,
        two_low: LOG10_2_LOW,
    };
    log_of_parts(parts, exponent, row, base)
}

/// The logarithm to base 10.
#[function]
pub fn log10(x: f64) -> f64 {
    let bits = x.raw_bits();
    if is_plain(bits) {
        let parts = parts(bits);
        log10_of_parts(parts, parts.exponent as f64)
    } else if is_small(x) {
        let parts = parts(normal_bits(x));
        log10_of_parts(parts, parts.exponent as f64 - 54.0)
    } else {
        logarithm_at_limit(x)
    }
}

/// ln(1 + x), without cancellation.
#[function]
pub fn ln_1p(x: f64) -> f64 {
    // From 2⁻⁵⁴ to 2⁶⁰: below, it is x itself, above, the one is lost.
    let exponent = ((x.raw_bits() >> 32) as u32 & 0x7fff_ffff).wrapping_sub(0x3c90_0000);
    if exponent < 0x0720_0000 && x > -1.0 {
        let whole = sum(1.0, x);
        let parts = parts(whole.high.raw_bits());
        let scale = f64::from_bits((1023_i32.wrapping_sub(parts.exponent) as u32 as u64) << 52);
        let fine = parts.fine + whole.low * scale;
        ln_of_parts(Parts { fine, ..parts }, parts.exponent as f64)
    } else {
        far_ln_1p(x)
    }
}

/// ln(1 + x) of what is next to zero, huge, or out of range.
#[function]
pub fn far_ln_1p(x: f64) -> f64 {
    if x.abs() < 0.5 { x } else { ln(1.0 + x) }
}

/// ln x of 2^`exponent` · `parts`, in two doubles, to some 66 bits.
#[inline]
#[function]
pub fn logarithm(parts: Parts, exponent: f64) -> Pair {
    let index = parts.row & 127;
    let reciprocal = COARSE_ROWS[index][0];
    let r_high = parts.coarse * reciprocal - 1.0;
    let r_low = parts.fine * reciprocal;
    let r = r_high + r_low;
    let z = r * r;
    let tail = (L3 + r * L4) + z * ((L5 + r * L6) + z * ((L7 + r * L8) + z * L9));

    // The first sum and the square of r_high are exact.
    let lead = ordered_sum(exponent * LN_2_HIGH + COARSE_ROWS[index][1] + r_high, r_low);
    let next = ordered_sum(lead.high, -0.5 * r_high * r_high);
    let cross = r_low * (r_high + 0.5 * r_low);
    let small = (r * z * tail - cross) + (COARSE_REST[index] + exponent * LN_2_LOW);
    ordered_sum(next.high, (next.low + lead.low) + small)
}
