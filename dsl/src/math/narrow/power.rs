//! Powers: x^y = 2^(y · log₂ x), with the logarithm and the product as sums of floats that have ten bits more than a
//! float.
//!
//! For the logarithm, a table has factors c of so few bits that r = m·c − 1 is exact, and a series gives log₂(1 + r).
//! Special values are those of C99, Annex F.

use super::super::RawBits as _;
use super::super::tables::{NARROW_LOG2_E_HIGH, NARROW_LOG2_E_LOW, NARROW_LOG2_ROWS};
use super::exponential::{ExponentF32, TO_STEPS, binary_beyond, far_step_power, step_power};
use super::logarithm::{is_plain, is_subnormal};
use super::{exact_mul_addf, ordered_sum};
use crate::prelude::*;

/// x^y for a negative x, from `value` = |x|^y.
#[function]
pub fn power_of_negative(value: f32, y: f32) -> f32 {
    // From 2²⁴ on, every number is even.
    if y.abs() >= 16_777_216.0 {
        value
    } else if y.floor() < y {
        f32::NAN
    } else if (0.5 * y).floor() >= 0.5 * y {
        value
    } else {
        -value
    }
}

/// x^y where x is zero, infinite or NaN, or y is infinite or NaN.
#[function]
pub fn special_power(x: f32, y: f32) -> f32 {
    if y.abs() <= 0.0 || (x - 1.0).abs() <= 0.0 {
        return 1.0;
    }
    let size = x.abs();
    if size.is_nan() || y.is_nan() {
        return f32::NAN;
    }
    if (size - 1.0).abs() <= 0.0 {
        return 1.0;
    }
    let value = if (size > 1.0) == (y > 0.0) { f32::INFINITY } else { 0.0 };
    // Of zero and infinity, an uneven power keeps the sign; others are positive, whole or not.
    let half = 0.5 * y;
    let odd = y.abs() < 16_777_216.0 && y.floor() >= y && half.floor() < half;
    if odd && 1.0_f32.copysign(x) < 0.0 { -value } else { value }
}

/// A number as a sum of three floats.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TripleF32 {
    /// The number, with a relative error of 2⁻⁷.
    pub high: f32,
    /// The larger part of the error of `high`: with it, the steps of a power can be chosen.
    pub middle: f32,
    /// The error of `high` + `middle`.
    pub low: f32,
}

/// The factor of r³, as a multiple of r²/2: 2/3 and, for r⁵/5, the best 0.336 · ρ² up to |r| = ρ = 0.0064. The row
/// around 1, where the logarithm is small, has |r| below 0.006.
#[crate::data]
const THIRD: f32 = 0.666_680_3;

/// The logarithm to base 2 of a positive, normal number, with a relative error of 2⁻³²; `less` is subtracted from its
/// exponent.
#[inline]
#[function]
fn binary_logarithm(x: f32, less: i32) -> TripleF32 {
    let bits = x.raw_bits();
    // Above 1 + 52.5/128 a significand is halved.
    let above = bits.wrapping_sub(0x3f34_8000);
    let exponent = (above as i32 >> 23).wrapping_sub(less) as f32;
    let row = ((above >> 16) & 127) as usize;
    let significand = f32::from_bits(bits.wrapping_sub(above & 0xff80_0000));
    let r = exact_mul_addf(significand, NARROW_LOG2_ROWS[row][0], -1.0);

    // log₂ e · (r − r²/2 + r³/3 − r⁴/4), its first term as a sum of two.
    let first = r * NARROW_LOG2_E_HIGH;
    let rest = exact_mul_addf(r, NARROW_LOG2_E_HIGH, -first) + r * NARROW_LOG2_E_LOW;
    let half = 0.5 * r;
    let square = half * first;
    let cube = square * (r * (THIRD - half));

    // Exact, and of so few digits that what its sum with the next loses is exact whichever is the larger.
    let whole = exponent + NARROW_LOG2_ROWS[row][1];
    let lead = ordered_sum(whole, first);
    TripleF32 {
        high: lead.high,
        middle: NARROW_LOG2_ROWS[row][2] - square,
        low: (rest + lead.low) + cube,
    }
}

/// The parts of an exponent that is less than 2¹⁵ in magnitude.
#[inline]
#[function]
fn exponent_of(power: TripleF32) -> ExponentF32 {
    let shifted = (power.high + power.middle) + TO_STEPS;
    let rest = ((power.high - (shifted - TO_STEPS)) + power.middle) + power.low;
    ExponentF32 { bits: shifted.raw_bits(), rest }
}

/// y · log₂ x for a positive, normal x; `less` is subtracted from its exponent.
#[inline]
#[function]
fn binary_power(x: f32, less: i32, y: f32) -> TripleF32 {
    let logarithm = binary_logarithm(x, less);
    let high = y * logarithm.high;
    let lost = exact_mul_addf(y, logarithm.high, -high);
    TripleF32 { high, middle: y * logarithm.middle, low: lost + y * logarithm.low }
}

/// x^y for any two numbers: results near the largest and smallest powers, subnormal or negative x, and special
/// values.
#[function]
pub fn far_powff(x: f32, y: f32) -> f32 {
    let size = x.abs();
    if size > 0.0 && size <= f32::MAX && y.abs() <= f32::MAX {
        let power = if is_subnormal(size) {
            binary_power(size * 16_777_216.0, 24, y)
        } else {
            binary_power(size, 0, y)
        };
        let value = if power.high > 130.0 {
            f32::INFINITY
        } else if power.high < -152.0 {
            0.0
        } else {
            let exponent = exponent_of(power);
            far_step_power(exponent.bits, binary_beyond(exponent.rest))
        };
        return if x > 0.0 { value } else { power_of_negative(value, y) };
    }
    special_power(x, y)
}

/// x^y; within 1 ulp. `y` = ±0 and `x` = 1 give 1; a negative x gives NaN unless y is a whole number; otherwise as in
/// C99, F.9.4.4.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    if is_plain(x) {
        let power = binary_power(x, 0, y);
        // Beyond, what is added to a row's power could lose bits below the normal numbers.
        if power.high.abs() < 110.0 {
            let exponent = exponent_of(power);
            return step_power(exponent.bits, binary_beyond(exponent.rest));
        }
    }
    far_powff(x, y)
}

/// x^n by squaring, in the order of [`super::super::power::powi`].
#[function]
pub fn powif(x: f32, n: i32) -> f32 {
    let mut digits = if n < 0 { 0u32.wrapping_sub(n as u32) } else { n as u32 };
    let mut result = 1.0;
    let mut base = x;
    for _ in 0..32 {
        if digits == 0 {
            break;
        }
        if (digits & 1) == 1 {
            result *= base;
        }
        base *= base;
        digits >>= 1;
    }
    if n < 0 { 1.0 / result } else { result }
}
