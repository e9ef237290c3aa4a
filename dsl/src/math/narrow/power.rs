//! Powers: x^y = 2^(y · log₂ x) with the logarithm and the product as sums of two floats.
//!
//! The power of two takes 128ths from a table. Special values are those of C99, Annex F.

use core::f32::consts::LN_2;

use super::super::RawBits as _;
use super::super::tables::NARROW_BINARY_ROWS;
use super::exponential::{far_scaled, scaled};
use super::logarithm::{binary_pair, is_plain, is_subnormal};
use super::{PairF32, exact_mul_addf};
use crate::prelude::*;

/// Of the Taylor series of 2^s, s, with the share of s³ that a multiple of s takes best: to |s| = 1/256 less than 2⁻³⁰ is left.
#[crate::data]
const FIRST: f32 = LN_2 + LN_2 * LN_2 * LN_2 / 8.0 / 65_536.0;
/// The same, s².
#[crate::data]
const SECOND: f32 = LN_2 * LN_2 / 2.0;

/// 1.5 · 2¹⁶: added to a smaller number it leaves the nearest 128th in the last bits.
#[crate::data]
const TO_STEPS: f32 = 98_304.0;

/// What x^y is for a negative x of which `value` is |x|^y.
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

/// An exponent of two as 128ths and what is left of it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExponentF32 {
    /// The bits of the number of 128ths with [`TO_STEPS`] added: the last seven choose a row, the rest is whole powers of two.
    pub bits: u32,
    /// What is left, −1/256 to 1/256.
    pub rest: f32,
}

/// The parts of an exponent that is less than 2¹⁵ in magnitude.
#[inline]
#[function]
fn exponent_of(power: PairF32) -> ExponentF32 {
    let shifted = power.high + TO_STEPS;
    ExponentF32 { bits: shifted.raw_bits(), rest: (power.high - (shifted - TO_STEPS)) + power.low }
}

/// `scale` · 2^s for the exponent s less its whole powers of two.
#[inline]
#[function]
fn binary(exponent: ExponentF32, scale: f32) -> f32 {
    let row = (exponent.bits & 127) as usize;
    let base = NARROW_BINARY_ROWS[row][0] * scale;
    let beyond = (base * exponent.rest) * (FIRST + exponent.rest * SECOND);
    base + (NARROW_BINARY_ROWS[row][1] * scale + beyond)
}

/// y · log₂ x of a positive, normal x; of its exponent, `less` is taken off.
#[inline]
#[function]
fn binary_power(x: f32, less: i32, y: f32) -> PairF32 {
    let logarithm = binary_pair(x, less);
    let high = y * logarithm.high;
    PairF32 { high, low: exact_mul_addf(y, logarithm.high, -high) + y * logarithm.low }
}

/// x^y of any two numbers: next to the largest and the smallest powers, of a subnormal or negative x, and special values.
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
            let whole = exponent.bits.wrapping_sub(0x47c0_0000) as i32 >> 7;
            far_scaled(binary(exponent, 1.0), whole)
        };
        return if x > 0.0 { value } else { power_of_negative(value, y) };
    }
    special_power(x, y)
}

/// x^y; within 1 ulp. Y = ±0 and x = 1 give 1; a negative x gives NaN unless y is whole; the rest
/// as in C99, F.9.4.4.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    if is_plain(x) {
        let power = binary_power(x, 0, y);
        // The low part of a row is still a normal number after scaling, or so small that it does not count.
        if power.high.abs() < 110.0 {
            let exponent = exponent_of(power);
            return binary(exponent, scaled(1.0, exponent.bits >> 7));
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
