//! The tangent.
//!
//! An angle is split into a row of a table of tangents T, as for the sine, and a remainder of at most π/128. With u
//! the tangent of the remainder, tan(c + t) = T + u + u·T·(T + u) / (1 − u·T). Near the zeros and poles, and beyond
//! 50 000 rad, the angle is reduced in two doubles.

use super::RawBits as _;
use super::pair::{Pair, quotient};
use super::reduction::reduce;
use super::sine::{MODERATE, TINY, TO_INTEGER};
use super::tables::{STEP_HIGH, STEP_LOW, STEPS_PER_RADIAN, TANGENT_POLYNOMIAL, TANGENT_ROWS};
use crate::prelude::*;

/// Coefficient of x³ in the Taylor series of the tangent. Up to |x| = π/128 the omitted terms are below 2⁻⁶⁰ of it.
#[crate::data]
const T3: f64 = 1.0 / 3.0;
/// Coefficient of x⁵.
#[crate::data]
const T5: f64 = 2.0 / 15.0;
/// Coefficient of x⁷.
#[crate::data]
const T7: f64 = 17.0 / 315.0;
/// Coefficient of x⁹.
#[crate::data]
const T9: f64 = 62.0 / 2_835.0;

/// Tangent of `row`·π/64 + `rest` for |rest| ≤ π/128, at least 2½ rows from zero and 4½ from the pole.
#[inline]
#[function]
fn from_row(row: u64, rest: f64) -> f64 {
    let index = (row & 63) as usize;
    let lead = TANGENT_ROWS[index][0];
    let z = rest * rest;
    let tangent = rest + rest * z * (T3 + z * (T5 + z * (T7 + z * T9)));
    let product = tangent * lead;
    lead + (TANGENT_ROWS[index][1] + (tangent + product * (lead + tangent) / (1.0 - product)))
}

/// Tangent of `x`, by reducing the angle in two doubles.
#[function]
pub fn by_reduction(x: f64) -> f64 {
    if x.abs() < TINY {
        return x;
    }
    let angle = reduce(x);
    if angle.high.abs() < 0.22 {
        let z = angle.high * angle.high;
        let end = TANGENT_POLYNOMIAL[5] + z * (TANGENT_POLYNOMIAL[6] + z * TANGENT_POLYNOMIAL[7]);
        let upper = TANGENT_POLYNOMIAL[2]
            + z * (TANGENT_POLYNOMIAL[3] + z * (TANGENT_POLYNOMIAL[4] + z * end));
        let tail = TANGENT_POLYNOMIAL[0] + z * (TANGENT_POLYNOMIAL[1] + z * upper);
        let low = angle.low + angle.high * z * tail;
        if (angle.quadrant & 1) == 0 {
            angle.high + low
        } else {
            quotient(Pair { high: -1.0, low: 0.0 }, Pair { high: angle.high, low }).high
        }
    } else {
        let shifted = angle.high * STEPS_PER_RADIAN + TO_INTEGER;
        let steps = shifted - TO_INTEGER;
        let rest = ((angle.high - steps * STEP_HIGH) - steps * STEP_LOW) + angle.low;
        from_row(shifted.raw_bits().wrapping_add(angle.quadrant << 5), rest)
    }
}

/// Tangent of an angle in rad, however large; measured within 0.88 ulp. ±0 gives ±0; ±∞ and NaN
/// give NaN.
#[function]
pub fn tan(x: f64) -> f64 {
    let shifted = x * STEPS_PER_RADIAN + TO_INTEGER;
    let row = shifted.raw_bits();
    let plain = (row.wrapping_add(2) & 63) > 4 && (row.wrapping_add(36) & 63) > 8;
    if plain && x.abs() < MODERATE {
        let steps = shifted - TO_INTEGER;
        from_row(row, (x - steps * STEP_HIGH) - steps * STEP_LOW)
    } else {
        by_reduction(x)
    }
}
