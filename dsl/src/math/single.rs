//! The elementary functions in single precision: computed in double precision to about 33 bits, and rounded once.
//! They have their own shorter polynomials and tables where that saves much time.

use core::f64::consts::{LN_2, LOG2_E, LOG10_2, PI};

use super::RawBits as _;
use super::arctangent::{atan, atan2};
use super::exponential::{TO_STEP, exp, exp_m1, exp2, step};
use super::hyperbolic::{cosh, sinh, tanh};
use super::logarithm::{at_limit, ln_1p, parts};
use super::power::{powf, powi};
use super::roots::{COARSE, coarse_root};
use super::sine::{C2, C4, S3, TO_INTEGER, by_reduction, signed};
use super::tables::{
    ARCSINE_F32, CUBE_ROOT_F32, EXPONENTIAL_F32, LOG2_F32, LOG2_ROWS_F32, SINE_ROWS, STEP_HIGH,
    STEP_LOW, STEPS_PER_RADIAN,
};
use super::tangent::tan;
use crate::prelude::*;

/// Sine of `x` + `quarter_turns` · π/2 for up to 2¹⁵ rad: a row of the table of sines, and two short Taylor
/// polynomials.
#[inline]
#[function]
fn moderate_sine(x: f64, quarter_turns: u64) -> f64 {
    let shifted = x * STEPS_PER_RADIAN + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let rest = (x - steps * STEP_HIGH) - steps * STEP_LOW;
    let row = shifted.raw_bits().wrapping_add(quarter_turns << 5);
    let sine = SINE_ROWS[(row & 63) as usize][0];
    let slope = SINE_ROWS[(row & 63) as usize][2];
    let z = rest * rest;
    signed(sine + (slope * rest + z * (S3 * slope * rest + sine * (C2 + z * C4))), row)
}

/// Sine of an angle in rad, however large; measured within 0.54 ulp. ±0 gives ±0; ±∞ and NaN give
/// NaN.
#[function]
pub fn sinf(x: f32) -> f32 {
    // From 2⁻²⁷, so that −0 stays what it is, to 2¹⁵.
    if (x.raw_bits() & 0x7fff_ffff).wrapping_sub(0x3200_0000) < 0x1500_0000 {
        moderate_sine(x as f64, 0) as f32
    } else {
        by_reduction(x as f64, 0) as f32
    }
}

/// Cosine of an angle in rad, however large; measured within 0.54 ulp. ±0 gives 1; ±∞ and NaN give
/// NaN.
#[function]
pub fn cosf(x: f32) -> f32 {
    // To 2¹⁵.
    if (x.raw_bits() & 0x7fff_ffff) < 0x4700_0000 {
        moderate_sine(x as f64, 1) as f32
    } else {
        by_reduction(x as f64, 1) as f32
    }
}

/// Sine and cosine of an angle in rad, with the bits of [`sinf`] and [`cosf`].
#[function]
pub fn sin_cosf(x: f32) -> (f32, f32) {
    (sinf(x), cosf(x))
}

/// Tangent of an angle in rad, however large; measured within 0.50 ulp. ±0 gives ±0; ±∞ and NaN
/// give NaN.
#[function]
pub fn tanf(x: f32) -> f32 {
    tan(x as f64) as f32
}

/// (asin √z)/√z for z from 0 to 1/4.
#[inline]
#[function]
fn arcsine_ratio(z: f64) -> f64 {
    let upper = ARCSINE_F32[3] + z * (ARCSINE_F32[4] + z * ARCSINE_F32[5]);
    1.0 + z * (ARCSINE_F32[0] + z * (ARCSINE_F32[1] + z * (ARCSINE_F32[2] + z * upper)))
}

/// Arcsine of −1 to 1, rad; measured within 0.52 ulp. ±0 gives ±0; numbers outside and NaN give
/// NaN.
#[function]
pub fn asinf(x: f32) -> f32 {
    let wide = x as f64;
    let size = wide.abs();
    if size < 0.5 {
        return (wide * arcsine_ratio(wide * wide)) as f32;
    }
    // Of what is negative the root is NaN.
    let z = 0.5 - 0.5 * size;
    let value = 0.5 * PI - 2.0 * z.sqrt() * arcsine_ratio(z);
    if x < 0.0 { -value as f32 } else { value as f32 }
}

/// Arccosine of −1 to 1, rad; measured within 0.52 ulp. 1 gives 0; numbers outside and NaN give
/// NaN.
#[function]
pub fn acosf(x: f32) -> f32 {
    let wide = x as f64;
    let size = wide.abs();
    if size < 0.5 {
        return (0.5 * PI - wide * arcsine_ratio(wide * wide)) as f32;
    }
    let z = 0.5 - 0.5 * size;
    let value = 2.0 * z.sqrt() * arcsine_ratio(z);
    if x < 0.0 { (PI - value) as f32 } else { value as f32 }
}

/// Arctangent, rad; measured within 0.50 ulp. ±0 gives ±0, ±∞ gives ±π/2, NaN gives NaN.
#[function]
pub fn atanf(x: f32) -> f32 {
    atan(x as f64) as f32
}

/// 2^`x`, if that is a normal number.
#[inline]
#[function]
fn power_of_two(x: f64) -> f64 {
    let shifted = x + TO_STEP;
    let r = x - (shifted - TO_STEP);
    let lead = step(shifted.raw_bits());
    lead + lead * r * (EXPONENTIAL_F32[0] + r * EXPONENTIAL_F32[1])
}

/// e^x; measured within 0.53 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn expf(x: f32) -> f32 {
    if x.abs() < 100.0 { power_of_two(x as f64 * LOG2_E) as f32 } else { exp(x as f64) as f32 }
}

/// 2^x; measured within 0.53 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn exp2f(x: f32) -> f32 {
    if x.abs() < 150.0 { power_of_two(x as f64) as f32 } else { exp2(x as f64) as f32 }
}

/// e^x − 1, without cancellation; measured within 0.50 ulp. ±0 gives ±0, −∞ gives −1, an overflow gives ∞, NaN gives
/// NaN.
#[function]
pub fn exp_m1f(x: f32) -> f32 {
    exp_m1(x as f64) as f32
}

/// Returns true if a number is positive, normal and finite.
#[inline]
#[function]
fn is_plain(x: f32) -> bool {
    x.raw_bits().wrapping_sub(0x0080_0000) < 0x7f00_0000
}

/// A positive number as 2^`exponent` · `significand`, with the significand from 0.705 to 1.410.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartsF32 {
    /// The exponent.
    pub exponent: i32,
    /// The row of the tables.
    pub row: usize,
    /// The significand.
    pub significand: f32,
}

/// The parts of a normal number.
#[inline]
#[function]
fn partsf(x: f32) -> PartsF32 {
    let bits = x.raw_bits();
    // Above 1 + 52.5/128 a significand is halved.
    let above = bits.wrapping_sub(0x3f34_8000);
    let exponent = above as i32 >> 23;
    PartsF32 {
        exponent,
        row: ((above >> 16) & 127) as usize,
        significand: f32::from_bits(bits.wrapping_sub((exponent as u32) << 23)),
    }
}

/// The logarithm to base 2 of 2^`exponent` · `significand`.
#[inline]
#[function]
fn logarithm_in_row(exponent: i32, row: usize, significand: f64) -> f64 {
    let r = significand * LOG2_ROWS_F32[row & 127][0] - 1.0;
    let upper = LOG2_F32[2] + r * LOG2_F32[3];
    (exponent as f64 + LOG2_ROWS_F32[row & 127][1])
        + r * (LOG2_F32[0] + r * (LOG2_F32[1] + r * upper))
}

/// The logarithm to base 2 of a positive, normal number.
#[inline]
#[function]
fn binary_logarithm(x: f32) -> f64 {
    let parts = partsf(x);
    logarithm_in_row(parts.exponent, parts.row, parts.significand as f64)
}

/// `unit` times the logarithm to base 2 of a number that is zero, negative, infinite, NaN or subnormal.
#[function]
pub fn far_logarithm(x: f32, unit: f64) -> f32 {
    if x > 0.0 && x < f32::MIN_POSITIVE {
        // By 2²³.
        ((binary_logarithm(x * 8_388_608.0) - 23.0) * unit) as f32
    } else {
        at_limit(x as f64) as f32
    }
}

/// The natural logarithm; measured within 0.51 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn lnf(x: f32) -> f32 {
    if is_plain(x) { (binary_logarithm(x) * LN_2) as f32 } else { far_logarithm(x, LN_2) }
}

/// The logarithm to base 2; measured within 0.51 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn log2f(x: f32) -> f32 {
    if is_plain(x) { binary_logarithm(x) as f32 } else { far_logarithm(x, 1.0) }
}

/// The logarithm to base 10; measured within 0.51 ulp. ±0 gives −∞, ∞ gives ∞; negative numbers and
/// NaN give NaN.
#[function]
pub fn log10f(x: f32) -> f32 {
    if is_plain(x) { (binary_logarithm(x) * LOG10_2) as f32 } else { far_logarithm(x, LOG10_2) }
}

/// ln(1 + x), without cancellation; measured within 0.51 ulp. ±0 gives ±0, −1 gives −∞, ∞ gives ∞;
/// numbers below −1 and NaN give NaN.
#[function]
pub fn ln_1pf(x: f32) -> f32 {
    // 2⁻²⁹: from here on 1 + x is exact in double.
    if x.abs() >= 1.8626451e-9 && x > -1.0 && x <= f32::MAX {
        let parts = parts((1.0 + x as f64).raw_bits());
        (logarithm_in_row(parts.exponent, parts.row, parts.significand) * LN_2) as f32
    } else {
        ln_1p(x as f64) as f32
    }
}

/// The hyperbolic sine; measured within 0.50 ulp. ±0 gives ±0, an overflow gives ±∞, NaN gives NaN.
#[function]
pub fn sinhf(x: f32) -> f32 {
    sinh(x as f64) as f32
}

/// The hyperbolic cosine; measured within 0.50 ulp. ±0 gives 1, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn coshf(x: f32) -> f32 {
    cosh(x as f64) as f32
}

/// The hyperbolic tangent; measured within 0.50 ulp. ±0 gives ±0, ±∞ gives ±1, NaN gives NaN.
#[function]
pub fn tanhf(x: f32) -> f32 {
    tanh(x as f64) as f32
}

/// The cube root; measured within 0.51 ulp. ±0 and ±∞ give themselves, NaN gives NaN.
///
/// The coarse root is improved by a polynomial in the ratio of its cube to `x`.
#[function]
pub fn cbrtf(x: f32) -> f32 {
    let size = (x as f64).abs();
    let upper = (size.raw_bits() >> 32) as u32;
    // Zero, infinite or NaN.
    if upper.wrapping_sub(1) >= 0x7fef_ffff {
        return x;
    }
    let coarse = coarse_root(upper, COARSE);
    let ratio = (coarse * coarse) * (coarse / size);
    let tail = CUBE_ROOT_F32[4] + ratio * (CUBE_ROOT_F32[5] + ratio * CUBE_ROOT_F32[6]);
    let upper = CUBE_ROOT_F32[2] + ratio * (CUBE_ROOT_F32[3] + ratio * tail);
    let value = coarse * (CUBE_ROOT_F32[0] + ratio * (CUBE_ROOT_F32[1] + ratio * upper));
    if x < 0.0 { -value as f32 } else { value as f32 }
}

/// The angle of the point (`x`, `y`) in rad, −π to π; measured within 0.50 ulp. ±0, ±∞ and NaN as
/// in C99, F.9.1.4.
#[function]
pub fn atan2f(y: f32, x: f32) -> f32 {
    atan2(y as f64, x as f64) as f32
}

/// x^y; measured within 0.53 ulp. `y` = ±0 and `x` = 1 give 1; a negative x gives NaN unless y is a whole number;
/// otherwise as in C99, F.9.4.4.
///
/// It is 2^(y · log₂ x), with the logarithm to about 38 bits.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    if is_plain(x) {
        let parts = partsf(x);
        let row = parts.row & 127;
        // The float as a double: its bits, with the other exponent.
        let wide =
            ((parts.significand.raw_bits() as u64) << 29).wrapping_add(0x3800_0000_0000_0000);
        let r = f64::from_bits(wide) * LOG2_ROWS_F32[row][0] - 1.0;
        let tail = (LOG2_F32[0] + r * LOG2_F32[1]) + r * r * (LOG2_F32[2] + r * LOG2_F32[3]);
        let factor = y as f64;
        let exponent = factor * (parts.exponent as f64 + LOG2_ROWS_F32[row][1]) + factor * r * tail;
        // Below 2⁹. Infinities, NaN and what leaves the range go the other way.
        if (exponent.raw_bits() >> 52 & 0x7ff) < 1023 + 9 {
            return power_of_two(exponent) as f32;
        }
    }
    powf(x as f64, y as f64) as f32
}

/// √(x² + y²), without intermediate overflow; measured within 0.50 ulp. An infinite `x` or `y` gives ∞, otherwise a
/// NaN gives NaN.
///
/// The squares are exact in double precision.
#[function]
pub fn hypotf(x: f32, y: f32) -> f32 {
    let length = (x as f64 * x as f64 + y as f64 * y as f64).sqrt();
    if length <= f64::MAX {
        length as f32
    } else if x.abs() > f32::MAX || y.abs() > f32::MAX {
        f32::INFINITY
    } else {
        f32::NAN
    }
}

/// x^n: the product in double, rounded once.
#[function]
pub fn powif(x: f32, n: i32) -> f32 {
    powi(x as f64, n) as f32
}
