//! Powers: x^y = 2^(y · log₂ x) with the logarithm and the product as sums of two floats.
//!
//! A significand m times a c of nine bits from a table is next to 1, and what it has beyond is exact as a sum of two. Special
//! values are those of C99, Annex F.

use super::super::RawBits as _;
use super::super::tables::{
    NARROW_BINARY_FIRST, NARROW_LOG2_E_HIGH, NARROW_LOG2_E_LOW, NARROW_POWER_ROWS,
};
use super::exponential::{beyond_binary, far_scaled, scaled};
use super::{PairF32, TO_INTEGER, leading, ordered_sum, sum};
use crate::prelude::*;

/// Of the Taylor series of ln(1 + x), x³: to |x| = 1/128 the terms behind the fifth power are below 2⁻³⁷ of it.
#[crate::data]
const THIRD: f32 = 1.0 / 3.0;
/// The same, x⁴, which is taken off.
#[crate::data]
const QUARTER: f32 = 1.0 / 4.0;
/// The same, x⁵.
#[crate::data]
const FIFTH: f32 = 1.0 / 5.0;

/// ln(1 + `high` + `low`) for −1/128 to 1/128.
#[inline]
#[function]
pub fn near_logarithm(r: PairF32) -> PairF32 {
    let upper = leading(r.high);
    let lower = r.high - upper;
    let lead = ordered_sum(r.high, -0.5 * upper * upper);
    let cubes = r.high * r.high * r.high * (THIRD - r.high * (QUARTER - r.high * FIFTH));
    let squares = lower * (upper + 0.5 * lower) + r.low * r.high;
    PairF32 { high: lead.high, low: lead.low + (r.low + (cubes - squares)) }
}

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
    let factor = NARROW_POWER_ROWS[row][0];
    let upper = leading(significand);
    let r = ordered_sum(upper * factor - 1.0, (significand - upper) * factor);

    let ln = near_logarithm(r);
    let upper = leading(ln.high);
    let lower = (ln.high - upper) + ln.low;
    let whole = exponent.wrapping_sub(less) as f32 + NARROW_POWER_ROWS[row][1];
    let lead = ordered_sum(whole, upper * NARROW_LOG2_E_HIGH);
    let small = upper * NARROW_LOG2_E_LOW + lower * (NARROW_LOG2_E_HIGH + NARROW_LOG2_E_LOW);
    ordered_sum(lead.high, lead.low + (NARROW_POWER_ROWS[row][2] + small))
}

/// What x^y is for a negative x of which `value` is |x|^y.
#[function]
pub fn power_of_negative(value: f32, y: f32) -> f32 {
    // From 2²⁴ on, every number is even.
    if y.abs() >= 16_777_216.0 {
        value
    } else if y.floor() != y {
        f32::NAN
    } else if (0.5 * y).floor() == 0.5 * y {
        value
    } else {
        -value
    }
}

/// x^y where x is zero, infinite or NaN, or y is infinite or NaN.
#[function]
pub fn special_power(x: f32, y: f32) -> f32 {
    if y == 0.0 || x == 1.0 {
        return 1.0;
    }
    let size = x.abs();
    if size.is_nan() || y.is_nan() {
        return f32::NAN;
    }
    if size == 1.0 {
        return 1.0;
    }
    let value = if (size > 1.0) == (y > 0.0) { f32::INFINITY } else { 0.0 };
    // Of zero and infinity, an uneven power keeps the sign; others are positive, whole or not.
    let half = 0.5 * y;
    let odd = y.abs() < 16_777_216.0 && y.floor() == y && half.floor() != half;
    if odd && 1.0_f32.copysign(x) < 0.0 { -value } else { value }
}

/// 2^(`high` + `low`), of any size.
#[inline]
#[function]
pub fn binary_of_pair(high: f32, low: f32) -> f32 {
    if high > 130.0 {
        return f32::INFINITY;
    }
    if high < -152.0 {
        return 0.0;
    }
    let shifted = (high + low) + TO_INTEGER;
    let rest = sum(high - (shifted - TO_INTEGER), low);
    // A product of 12 and 4 bits is exact.
    let upper = leading(rest.high);
    let lead = ordered_sum(1.0, upper * 0.6875);
    let lower = ((rest.high - upper) + rest.low) * 0.6875;
    let beyond = beyond_binary(rest.high, NARROW_BINARY_FIRST);
    let value = lead.high + (lead.low + (lower + beyond));
    let steps = shifted.raw_bits().wrapping_sub(0x4b40_0000) as i32;
    if high.abs() < 125.0 { scaled(value, steps as u32) } else { far_scaled(value, steps) }
}

/// x^y; within 1 ulp. Y = ±0 and x = 1 give 1; a negative x gives NaN unless y is whole; the rest
/// as in C99, F.9.4.4.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    let size = x.abs();
    if size > 0.0 && size <= f32::MAX && y.abs() <= f32::MAX {
        let small = size < f32::MIN_POSITIVE;
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
