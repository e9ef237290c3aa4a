//! Sine and cosine.
//!
//! An angle is split into a multiple of π/64, which is in two parts (Cody and Waite, *Software Manual for the
//! Elementary Functions*, 1980), and a remainder of at most π/128. The multiple has a row in a table of sines; the
//! remainder is added by the addition theorem with two short Taylor polynomials (P. T. P. Tang, *Table-lookup
//! algorithms for elementary functions*, ARITH-10, 1991). Near a multiple of π, and beyond 50 000 rad, the angle is
//! reduced in two doubles: [`super::reduction`].

use super::RawBits as _;
use super::reduction::{ReducedAngle, reduce};
use super::tables::{SINE_POLYNOMIAL, SINE_ROWS, STEP_HIGH, STEP_LOW, STEPS_PER_RADIAN};
use crate::prelude::*;

/// Up to this angle, in rad, the number of steps of π/64 is below 2²⁰.
#[crate::data]
pub(crate) const MODERATE: f64 = 50_000.0;
/// 1.5 · 2⁵²: added to a smaller number it leaves the nearest integer in the last bits.
#[crate::data]
pub(crate) const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// 2⁻²⁷: a smaller angle equals its sine and its tangent to the last bit.
#[crate::data]
pub(crate) const TINY: f64 = 7.450580596923828e-9;

/// Up to this angle, in rad, the sine is computed by an odd polynomial.
#[crate::data]
const NEAR_ZERO: f64 = 0.27;

/// Coefficient of x³ in the Taylor series of the sine. Up to |x| = π/128 the omitted terms are below 2⁻⁶¹ of it.
#[crate::data]
pub(crate) const S3: f64 = -1.0 / 6.0;
/// Coefficient of x⁵.
#[crate::data]
const S5: f64 = 1.0 / 120.0;
/// Coefficient of x⁷.
#[crate::data]
const S7: f64 = -1.0 / 5_040.0;
/// Coefficient of x² in the Taylor series of the cosine. Up to |x| = π/128 the omitted terms are below 2⁻⁵⁸.
#[crate::data]
pub(crate) const C2: f64 = -1.0 / 2.0;
/// Coefficient of x⁴.
#[crate::data]
pub(crate) const C4: f64 = 1.0 / 24.0;
/// Coefficient of x⁶.
#[crate::data]
const C6: f64 = -1.0 / 720.0;

/// `value`, negated if `row` is in the second half of a turn; a turn has 128 rows.
#[inline]
#[function]
pub(crate) fn signed(value: f64, row: u64) -> f64 {
    if (row & 64) == 0 { value } else { -value }
}

/// Sine of `row`·π/64 + `rest` for |rest| ≤ π/128, if the sine is at least 1/4.
#[inline]
#[function]
fn from_row(row: u64, rest: f64) -> f64 {
    let index = (row & 63) as usize;
    let lead = SINE_ROWS[index][0];
    let slope = SINE_ROWS[index][2];
    let z = rest * rest;
    let sine = rest + rest * z * (S3 + z * (S5 + z * S7));
    let versine = z * (C2 + z * (C4 + z * C6));
    signed(lead + (SINE_ROWS[index][1] + (slope * sine + lead * versine)), row)
}

/// Sine of `high` + `low`, which is from −0.27 to 0.27.
#[inline]
#[function]
fn near_zero(high: f64, low: f64) -> f64 {
    let z = high * high;
    let tail = SINE_POLYNOMIAL[0]
        + z * (SINE_POLYNOMIAL[1]
            + z * (SINE_POLYNOMIAL[2] + z * (SINE_POLYNOMIAL[3] + z * SINE_POLYNOMIAL[4])));
    high + (low + high * z * tail)
}

/// Sine of a reduced angle + `quarter_turns` · π/2.
#[function]
fn of_reduced(angle: ReducedAngle, quarter_turns: u64) -> f64 {
    let quadrant = angle.quadrant.wrapping_add(quarter_turns);
    if (quadrant & 1) == 0 && angle.high.abs() < NEAR_ZERO {
        let value = near_zero(angle.high, angle.low);
        if (quadrant & 2) == 0 { value } else { -value }
    } else {
        let shifted = angle.high * STEPS_PER_RADIAN + TO_INTEGER;
        let steps = shifted - TO_INTEGER;
        let rest = ((angle.high - steps * STEP_HIGH) - steps * STEP_LOW) + angle.low;
        from_row(shifted.raw_bits().wrapping_add(quadrant << 5), rest)
    }
}

/// Sine of `x` + `quarter_turns` · π/2, by reducing the angle in two doubles. For a tiny `x`, `quarter_turns` must be
/// 0 or 1.
#[function]
pub fn by_reduction(x: f64, quarter_turns: u64) -> f64 {
    if x.abs() < TINY {
        return if quarter_turns == 0 { x } else { 1.0 };
    }
    if quarter_turns == 0 && x.abs() < NEAR_ZERO {
        return near_zero(x, 0.0);
    }
    of_reduced(reduce(x), quarter_turns)
}

/// Sine of `x` + `quarter_turns` · π/2.
#[inline]
#[function]
fn turned(x: f64, quarter_turns: u64) -> f64 {
    let shifted = x * STEPS_PER_RADIAN + TO_INTEGER;
    let row = shifted.raw_bits().wrapping_add(quarter_turns << 5);
    // Within 5½ rows of a multiple of π the sine is below 0.27, and the sum loses too much.
    if x.abs() < MODERATE && (row.wrapping_add(5) & 63) > 10 {
        let steps = shifted - TO_INTEGER;
        from_row(row, (x - steps * STEP_HIGH) - steps * STEP_LOW)
    } else {
        by_reduction(x, quarter_turns)
    }
}

/// Sine of an angle in rad, however large; measured within 0.65 ulp. ±0 gives ±0; ±∞ and NaN give
/// NaN.
#[function]
pub fn sin(x: f64) -> f64 {
    turned(x, 0)
}

/// Cosine of an angle in rad, however large; measured within 0.66 ulp. ±0 gives 1; ±∞ and NaN give
/// NaN.
#[function]
pub fn cos(x: f64) -> f64 {
    turned(x, 1)
}

/// Sine and cosine of an angle in rad, with the bits of [`sin`] and [`cos`] and one reduction.
#[function]
pub fn sin_cos(x: f64) -> (f64, f64) {
    if x.abs() < MODERATE {
        let shifted = x * STEPS_PER_RADIAN + TO_INTEGER;
        let steps = shifted - TO_INTEGER;
        let rest = (x - steps * STEP_HIGH) - steps * STEP_LOW;
        let row = shifted.raw_bits();
        // Next to a multiple of π/2 one of them is small.
        let place = row.wrapping_add(5) & 63;
        if (place & 31) > 10 {
            (from_row(row, rest), from_row(row.wrapping_add(32), rest))
        } else if place > 10 {
            (from_row(row, rest), by_reduction(x, 1))
        } else {
            (by_reduction(x, 0), from_row(row.wrapping_add(32), rest))
        }
    } else {
        let angle = reduce(x);
        (of_reduced(angle, 0), of_reduced(angle, 1))
    }
}
