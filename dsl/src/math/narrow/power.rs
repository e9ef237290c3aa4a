//! Powers: x^y = 2^(y · log₂ x) with the logarithm and the product as sums of two floats.
//!
//! A table has the logarithm of the middle c of each row of significands. With d the way of a significand from there, which is
//! exact, and q = d/(c·ln 2), the rest is the series of log₂(1 + q·ln 2); its first two terms are sums of an exact part and a small
//! one. The power of two takes 32nds from a table. Special values are those of C99, Annex F.

use core::f32::consts::LN_2;

use super::super::RawBits as _;
use super::super::tables::{NARROW_BINARY_ROWS, NARROW_POWER_ROWS};
use super::exponential::far_scaled;
use super::logarithm::is_subnormal;
use super::{PairF32, leading, ordered_sum};
use crate::prelude::*;

/// Of the Taylor series of log₂(1 + q·ln 2), q², which is taken off: to |q| = 2⁻⁷ the terms behind the fourth power are below 2⁻³²
/// of it.
#[crate::data]
const SECOND: f32 = LN_2 / 2.0;
/// The same, q³.
#[crate::data]
const THIRD: f32 = LN_2 * LN_2 / 3.0;
/// The same, q⁴, which is taken off.
#[crate::data]
const FOURTH: f32 = LN_2 * LN_2 * LN_2 / 4.0;

/// Of the Taylor series of 2^s, s²: to |s| = 1/64 the terms behind the third power are below 2⁻³⁰.
#[crate::data]
const SQUARE: f32 = LN_2 * LN_2 / 2.0;
/// The same, s³.
#[crate::data]
const CUBE: f32 = LN_2 * LN_2 * LN_2 / 6.0;

/// 1.5 · 2¹⁸: added to a smaller number it leaves the nearest 32nd in the last bits.
#[crate::data]
const TO_THIRTY_SECONDS: f32 = 393_216.0;

/// The logarithm to base 2 of a positive, normal number; of its exponent, `less` is taken off.
#[inline]
#[function]
pub fn logarithm(x: f32, less: i32) -> PairF32 {
    let bits = x.raw_bits();
    // Above 1 + 52.5/128 a significand is halved.
    let above = bits.wrapping_sub(0x3f34_8000);
    let exponent = above as i32 >> 23;
    let row = ((above >> 16) & 127) as usize;
    let significand = f32::from_bits(bits.wrapping_sub((exponent as u32) << 23));
    // From the middle of the row it has at most 15 bits, whose product with nine is exact.
    let way = significand - f32::from_bits((above & 0x007f_0000).wrapping_add(0x3f35_0000));
    let high = way * NARROW_POWER_ROWS[row][0];
    let low = way * NARROW_POWER_ROWS[row][1];

    let upper = leading(high);
    let lower = (high - upper) + low;
    let q = high + low;
    let whole = exponent.wrapping_sub(less) as f32 + NARROW_POWER_ROWS[row][2];
    let lead = ordered_sum(whole, high);
    let cubes = q * q * q * (THIRD - q * FOURTH);
    let small = NARROW_POWER_ROWS[row][3] + (low + (cubes - SECOND * (lower * (upper + q))));
    let squared = ordered_sum(lead.high, -SECOND * (upper * upper));
    ordered_sum(squared.high, lead.low + (squared.low + small))
}

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

/// 2^`exponent`/32 times a `value` next to 1, where the exponent `high` of the power is far from zero.
#[function]
pub fn far_power(value: f32, exponent: i32, high: f32) -> f32 {
    if high > 130.0 {
        f32::INFINITY
    } else if high < -152.0 {
        0.0
    } else {
        far_scaled(value, exponent >> 5)
    }
}

/// 2^(`high` + `low`), of any size.
#[inline]
#[function]
pub fn binary_of_pair(high: f32, low: f32) -> f32 {
    let shifted = (high + low) + TO_THIRTY_SECONDS;
    let s = (high - (shifted - TO_THIRTY_SECONDS)) + low;
    let steps = shifted.raw_bits().wrapping_sub(0x48c0_0000);
    let row = (steps & 31) as usize;
    let base = NARROW_BINARY_ROWS[row][0];
    let beyond = s * (LN_2 + s * (SQUARE + s * CUBE));
    let value = base + (NARROW_BINARY_ROWS[row][1] + base * beyond);
    if high.abs() < 125.0 {
        f32::from_bits(value.raw_bits().wrapping_add((steps & 0xffff_ffe0) << 18))
    } else {
        far_power(value, steps as i32, high)
    }
}

/// x^y; within 1 ulp. Y = ±0 and x = 1 give 1; a negative x gives NaN unless y is whole; the rest
/// as in C99, F.9.4.4.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    let size = x.abs();
    if size > 0.0 && size <= f32::MAX && y.abs() <= f32::MAX {
        let small = is_subnormal(size);
        let logarithm = if small { logarithm(size * 16_777_216.0, 24) } else { logarithm(size, 0) };
        // 12 bits each: their product is exact.
        let upper = leading(logarithm.high);
        let lower = (logarithm.high - upper) + logarithm.low;
        let y_upper = leading(y);
        let value = binary_of_pair(y_upper * upper, (y - y_upper) * upper + y * lower);
        return if x > 0.0 { value } else { power_of_negative(value, y) };
    }
    special_power(x, y)
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
