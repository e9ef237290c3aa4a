//! The elementary functions in single precision: computed in double to some 33 bits, and rounded
//! once. Where that saves much they have shorter polynomials and tables of their own.

use core::f64::consts::{FRAC_2_PI, LN_2, LOG10_2, PI};

use super::RawBits as _;
use super::arctangent::{atan, atan2};
use super::exponential::{exp, exp_m1, exp2};
use super::hyperbolic::{cosh, sinh, tanh};
use super::logarithm::{ln_1p, logarithm_at_limit};
use super::power::{powf, powi};
use super::roots::{COARSE, coarse_root};
use super::sine::{MODERATE, TO_INTEGER, sine_by_reduction};
use super::tables::{
    ARCSINE_F32, COSINE_F32, CUBE_ROOT_F32, EXPONENTIAL_F32, FINER_LOG2_F32, LOG2_F32,
    LOG2_ROWS_F32, POWERS_F32, QUARTER_TURN_1, QUARTER_TURN_REST, SINE_F32, STEPS_PER_UNIT_F32,
};
use super::tangent::tan;
use crate::prelude::*;

/// Sine of `x` + `turns` · π/2.
#[inline]
#[function]
pub fn turned_sinef(x: f64, turns: u64) -> f64 {
    if x.abs() < MODERATE {
        let shifted = x * FRAC_2_PI + TO_INTEGER;
        let taken = shifted - TO_INTEGER;
        let rest = (x - taken * QUARTER_TURN_1) - taken * QUARTER_TURN_REST;
        let quadrant = shifted.raw_bits().wrapping_add(turns);
        let z = rest * rest;
        let value = if (quadrant & 1) == 0 {
            let upper = SINE_F32[2] + z * SINE_F32[3];
            rest * (1.0 + z * (SINE_F32[0] + z * (SINE_F32[1] + z * upper)))
        } else {
            1.0 + z * (z * (COSINE_F32[0] + z * (COSINE_F32[1] + z * COSINE_F32[2])) - 0.5)
        };
        if (quadrant & 2) == 0 { value } else { -value }
    } else {
        sine_by_reduction(x, turns)
    }
}

/// Sine of an angle in rad.
#[function]
pub fn sinf(x: f32) -> f32 {
    turned_sinef(x as f64, 0) as f32
}

/// Cosine of an angle in rad.
#[function]
pub fn cosf(x: f32) -> f32 {
    turned_sinef(x as f64, 1) as f32
}

/// Tangent of an angle in rad.
#[function]
pub fn tanf(x: f32) -> f32 {
    tan(x as f64) as f32
}

/// (asin √z)/√z for 0 to 1/4.
#[inline]
#[function]
pub fn arcsine_ratio(z: f64) -> f64 {
    let upper = ARCSINE_F32[3] + z * (ARCSINE_F32[4] + z * ARCSINE_F32[5]);
    1.0 + z * (ARCSINE_F32[0] + z * (ARCSINE_F32[1] + z * (ARCSINE_F32[2] + z * upper)))
}

/// Arcsine, rad; NaN outside −1 to 1.
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

/// Arccosine, rad; NaN outside −1 to 1.
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

/// Arctangent, rad.
#[function]
pub fn atanf(x: f32) -> f32 {
    atan(x as f64) as f32
}

/// 2^(`steps`/32) for a normal number.
#[inline]
#[function]
pub fn power_of_steps(steps: f64) -> f64 {
    let shifted = steps + TO_INTEGER;
    let r = steps - (shifted - TO_INTEGER);
    let bits = shifted.raw_bits();
    // The upper half alone changes: one addition where a word has 32 bits.
    let row = POWERS_F32[(bits & 31) as usize];
    let upper = ((row >> 32) as u32).wrapping_add((bits as u32) << 15);
    let lead = f64::from_bits(((upper as u64) << 32) | (row & 0xffff_ffff));
    lead + lead * (r * (EXPONENTIAL_F32[0] + r * (EXPONENTIAL_F32[1] + r * EXPONENTIAL_F32[2])))
}

/// e^x.
#[function]
pub fn expf(x: f32) -> f32 {
    if x.abs() < 100.0 {
        power_of_steps(x as f64 * STEPS_PER_UNIT_F32) as f32
    } else {
        exp(x as f64) as f32
    }
}

/// 2^x.
#[function]
pub fn exp2f(x: f32) -> f32 {
    if x.abs() < 150.0 { power_of_steps(x as f64 * 32.0) as f32 } else { exp2(x as f64) as f32 }
}

/// e^x − 1, without cancellation.
#[function]
pub fn exp_m1f(x: f32) -> f32 {
    exp_m1(x as f64) as f32
}

/// Whether a number is positive, normal and finite.
#[inline]
#[function]
pub fn is_plain(x: f32) -> bool {
    x.raw_bits().wrapping_sub(0x0080_0000) < 0x7f00_0000
}

/// log₂ of `exponent` and a significand from 0.703 to 1.406 with its row.
#[inline]
#[function]
pub fn logarithm_in_row(exponent: f64, significand: f64, row: u32) -> f64 {
    let index = (row & 31) as usize;
    let r = significand * LOG2_ROWS_F32[index][0] - 1.0;
    let tail = LOG2_F32[2] + r * (LOG2_F32[3] + r * LOG2_F32[4]);
    let curved = r * (LOG2_F32[0] + r * (LOG2_F32[1] + r * tail));
    (exponent + LOG2_ROWS_F32[index][1]) + curved
}

/// The same to some 40 bits, for [`powff`].
#[inline]
#[function]
pub fn finer_logarithm(x: f32) -> f64 {
    let bits = x.raw_bits();
    let exponent = bits.wrapping_sub(0x3f34_0000) as i32 >> 23;
    let significand = f32::from_bits(bits.wrapping_sub((exponent as u32) << 23));
    let index = ((bits >> 18) & 31) as usize;
    let r = significand as f64 * LOG2_ROWS_F32[index][0] - 1.0;
    let z = r * r;
    let upper = (FINER_LOG2_F32[4] + r * FINER_LOG2_F32[5]) + z * FINER_LOG2_F32[6];
    let tail = (FINER_LOG2_F32[2] + r * FINER_LOG2_F32[3]) + z * upper;
    let curved = r * ((FINER_LOG2_F32[0] + r * FINER_LOG2_F32[1]) + z * tail);
    (exponent as f64 + LOG2_ROWS_F32[index][1]) + curved
}

/// The logarithm to base 2 of a positive, normal number.
#[inline]
#[function]
pub fn binary_logarithm(x: f32) -> f64 {
    let bits = x.raw_bits();
    // Above 1 + 13/32 a significand is halved.
    let exponent = bits.wrapping_sub(0x3f34_0000) as i32 >> 23;
    let significand = f32::from_bits(bits.wrapping_sub((exponent as u32) << 23));
    logarithm_in_row(exponent as f64, significand as f64, bits >> 18)
}

/// `unit` times the logarithm to base 2 of what is zero, negative, infinite, NaN, or below the normal
/// numbers.
#[function]
pub fn far_logarithm(x: f32, unit: f64) -> f32 {
    if x > 0.0 && x < f32::MIN_POSITIVE {
        // By 2²³.
        ((binary_logarithm(x * 8_388_608.0) - 23.0) * unit) as f32
    } else {
        logarithm_at_limit(x as f64) as f32
    }
}

/// The natural logarithm.
#[function]
pub fn lnf(x: f32) -> f32 {
    if is_plain(x) { (binary_logarithm(x) * LN_2) as f32 } else { far_logarithm(x, LN_2) }
}

/// The logarithm to base 2.
#[function]
pub fn log2f(x: f32) -> f32 {
    if is_plain(x) { binary_logarithm(x) as f32 } else { far_logarithm(x, 1.0) }
}

/// The logarithm to base 10.
#[function]
pub fn log10f(x: f32) -> f32 {
    if is_plain(x) { (binary_logarithm(x) * LOG10_2) as f32 } else { far_logarithm(x, LOG10_2) }
}

/// ln(1 + x), without cancellation.
#[function]
pub fn ln_1pf(x: f32) -> f32 {
    // 2⁻²⁹: from here on 1 + x is exact in double.
    if x.abs() >= 1.8626451e-9 && x > -1.0 && x <= f32::MAX {
        let bits = (1.0 + x as f64).raw_bits();
        let exponent = ((bits >> 32) as u32).wrapping_sub(0x3fe6_8000) as i32 >> 20;
        let significand = f64::from_bits(bits.wrapping_sub((exponent as u32 as u64) << 52));
        let row = (bits >> 47) as u32;
        (logarithm_in_row(exponent as f64, significand, row) * LN_2) as f32
    } else {
        ln_1p(x as f64) as f32
    }
}

/// The hyperbolic sine.
#[function]
pub fn sinhf(x: f32) -> f32 {
    sinh(x as f64) as f32
}

/// The hyperbolic cosine.
#[function]
pub fn coshf(x: f32) -> f32 {
    cosh(x as f64) as f32
}

/// The hyperbolic tangent.
#[function]
pub fn tanhf(x: f32) -> f32 {
    tanh(x as f64) as f32
}

/// The cube root: the coarse one, better by a polynomial in the ratio of its cube to `x`.
#[function]
pub fn cbrtf(x: f32) -> f32 {
    let size = (x as f64).abs();
    if !(size > 0.0 && size <= f64::MAX) {
        return x;
    }
    let coarse = coarse_root((size.raw_bits() >> 32) as u32, COARSE);
    let ratio = (coarse * coarse) * (coarse / size);
    let tail = CUBE_ROOT_F32[4] + ratio * (CUBE_ROOT_F32[5] + ratio * CUBE_ROOT_F32[6]);
    let upper = CUBE_ROOT_F32[2] + ratio * (CUBE_ROOT_F32[3] + ratio * tail);
    let value = coarse * (CUBE_ROOT_F32[0] + ratio * (CUBE_ROOT_F32[1] + ratio * upper));
    if x < 0.0 { -value as f32 } else { value as f32 }
}

/// The angle of the point (`x`, `y`) in rad, −π to π.
#[function]
pub fn atan2f(y: f32, x: f32) -> f32 {
    atan2(y as f64, x as f64) as f32
}

/// x^y.
#[function]
pub fn powff(x: f32, y: f32) -> f32 {
    if is_plain(x) {
        let exponent = y as f64 * finer_logarithm(x);
        // Infinities, NaN and what leaves the range go the other way.
        if exponent.abs() < 1000.0 {
            return power_of_steps(exponent * 32.0) as f32;
        }
    }
    powf(x as f64, y as f64) as f32
}

/// √(x² + y²): the squares are exact in double.
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
