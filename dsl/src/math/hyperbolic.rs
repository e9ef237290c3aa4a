//! The hyperbolic functions.
//!
//! Sine and cosine come from e^x and e^(−x), both before their last rounding, which share the even and odd halves of
//! one polynomial. The tangent comes from a table by the addition theorem, and from 4 on from e^(2x). Near zero, sine
//! and tangent are polynomials.

use super::RawBits as _;
use super::exponential::{E2, E3, E4, E5, NORMAL, far, power, step, step_rest};
use super::pair::ordered_sum;
use super::sine::TO_INTEGER;
use super::tables::{
    SINH_POLYNOMIAL, STEPS_PER_UNIT, TANH_POLYNOMIAL, TANH_ROWS, UNIT_STEP_HIGH, UNIT_STEP_LOW,
};
use crate::prelude::*;

/// Coefficient of x³ in the Taylor series of the hyperbolic tangent. Up to |x| = 1/32 the omitted terms are below 2⁻⁵⁶
/// of it.
#[crate::data]
const T3: f64 = -1.0 / 3.0;
/// Coefficient of x⁵.
#[crate::data]
const T5: f64 = 2.0 / 15.0;
/// Coefficient of x⁷.
#[crate::data]
const T7: f64 = -17.0 / 315.0;
/// Coefficient of x⁹.
#[crate::data]
const T9: f64 = 62.0 / 2_835.0;

/// Half of e^x + `sign` · e^(−x) for x from 0 to 660, or from 0.3 if `sign` is −1.
#[inline]
#[function]
fn half_of_both(x: f64, sign: f64) -> f64 {
    let shifted = x * STEPS_PER_UNIT + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let r = (x - steps * UNIT_STEP_HIGH) - steps * UNIT_STEP_LOW;
    let up = shifted.raw_bits();
    let down = 0u64.wrapping_sub(up);
    let z = r * r;
    let even = z * (E2 + z * E4);
    let odd = r + r * z * (E3 + z * E5);
    let rising = 0.5 * step(up);
    let falling = sign * 0.5 * step(down);
    let lead = ordered_sum(rising, falling);
    let rest = rising * (step_rest(up) + (even + odd)) + falling * (step_rest(down) + (even - odd));
    lead.high + (lead.low + rest)
}

/// The hyperbolic sine; measured within 0.53 ulp. ±0 gives ±0, an overflow gives ±∞, NaN gives NaN.
#[function]
pub fn sinh(x: f64) -> f64 {
    let size = x.abs();
    if size < 0.3 {
        let z = x * x;
        let tail = SINH_POLYNOMIAL[0]
            + z * (SINH_POLYNOMIAL[1]
                + z * (SINH_POLYNOMIAL[2] + z * (SINH_POLYNOMIAL[3] + z * SINH_POLYNOMIAL[4])));
        return x + x * z * tail;
    }
    let value = if size < NORMAL { half_of_both(size, -1.0) } else { far(size, 0.0, -1) };
    if x < 0.0 { -value } else { value }
}

/// The hyperbolic cosine; measured within 0.52 ulp. ±0 gives 1, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn cosh(x: f64) -> f64 {
    let size = x.abs();
    if size < NORMAL { half_of_both(size, 1.0) } else { far(size, 0.0, -1) }
}

/// The hyperbolic tangent of numbers from 4 on, and of NaN.
#[function]
pub fn far_tangent(size: f64) -> f64 {
    if size < 22.0 {
        let power = power(2.0 * size);
        let lead = step(power.steps);
        1.0 - 2.0 / ((lead + lead * power.rest) + 1.0)
    } else if size >= 22.0 {
        1.0
    } else {
        size
    }
}

/// The hyperbolic tangent; measured within 0.66 ulp. ±0 gives ±0, ±∞ gives ±1, NaN gives NaN.
#[function]
pub fn tanh(x: f64) -> f64 {
    let size = x.abs();
    if size < 0.25 {
        let z = x * x;
        let upper = TANH_POLYNOMIAL[4]
            + z * (TANH_POLYNOMIAL[5] + z * (TANH_POLYNOMIAL[6] + z * TANH_POLYNOMIAL[7]));
        let tail = TANH_POLYNOMIAL[0]
            + z * (TANH_POLYNOMIAL[1]
                + z * (TANH_POLYNOMIAL[2] + z * (TANH_POLYNOMIAL[3] + z * upper)));
        return if size < 7.450580596923828e-9 { x } else { x + x * z * tail };
    }
    let value = if size < 4.0 {
        // Rows stand in the middle of sixteenths.
        let shifted = (size * 16.0 - 0.5) + TO_INTEGER;
        let index = (shifted.raw_bits() & 63) as usize;
        let t = size - ((shifted - TO_INTEGER) + 0.5) * 0.0625;
        let z = t * t;
        let tangent = t + t * z * (T3 + z * (T5 + z * (T7 + z * T9)));
        let lead = TANH_ROWS[index][0];
        let product = tangent * lead;
        lead + (TANH_ROWS[index][1] + (tangent - product * (lead + tangent) / (1.0 + product)))
    } else {
        far_tangent(size)
    };
    if x < 0.0 { -value } else { value }
}
