//! Sine and cosine: a table has 64ths of half a turn, and a short polynomial gives the remainder (P. T. P. Tang). No
//! branch depends on the quadrant.

use super::super::RawBits as _;
use super::super::tables::{NARROW_SINE_CUBE, NARROW_SINE_ROWS};
use super::reduction::{SteppedF32, stepped, stepped_far};
use crate::prelude::*;

/// 2⁻¹²: a smaller angle equals its sine and its tangent to the last bit.
#[crate::data]
pub(crate) const TINY: f32 = 2.4414063e-4;

/// Up to this angle, in rad, the number of steps is below 2¹¹.
#[crate::data]
const FEW_STEPS: f32 = 100.0;

/// Number of steps from the first row of the table to the row for the sine of 0.
#[crate::data]
const SINE_ROW: u32 = 32;
/// Number of steps from the first row of the table to the row for the sine of π/2, which is the cosine of 0.
#[crate::data]
const COSINE_ROW: u32 = 64;

/// Sine of an angle given as steps; `from` is the number of steps from the first row to the row for an angle of 0.
#[inline]
#[function]
fn sine_of_steps(angle: SteppedF32, from: u32) -> f32 {
    let steps = angle.steps.wrapping_add(from);
    let row = (steps & 63) as usize;
    let z = angle.high * angle.high;
    // sin(c + r) = sin c + r + (cos c − 1) · sin r + (sin r − r) + sin c · (cos r − 1); the sum of the first two without loss.
    let beyond = angle.low + angle.high * (z * NARROW_SINE_CUBE);
    let sum = NARROW_SINE_ROWS[row][0] + angle.high;
    let lost = angle.high - (sum - NARROW_SINE_ROWS[row][0]);
    let turned = (angle.high + beyond) * NARROW_SINE_ROWS[row][2] + beyond;
    let value = sum + (((lost + NARROW_SINE_ROWS[row][1]) + z * NARROW_SINE_ROWS[row][3]) + turned);
    // Every other half turn changes the sign.
    f32::from_bits(value.raw_bits() ^ ((steps & 64) << 25))
}

/// Sine of an angle in rad that is nearly 0 or above [`FEW_STEPS`].
#[function]
pub fn far_sine(x: f32) -> f32 {
    if x.abs() < TINY {
        // −0 stays what it is.
        x
    } else if x.abs() <= f32::MAX {
        sine_of_steps(stepped_far(x), SINE_ROW)
    } else {
        f32::NAN
    }
}

/// Cosine of an angle in rad above [`FEW_STEPS`].
#[function]
pub fn far_cosine(x: f32) -> f32 {
    if x.abs() <= f32::MAX { sine_of_steps(stepped_far(x), COSINE_ROW) } else { f32::NAN }
}

/// Returns true if an angle is from [`TINY`] to [`FEW_STEPS`] rad, by one comparison: the bits of floats have the
/// order of the floats.
#[inline]
#[function]
fn is_moderate(x: f32) -> bool {
    (x.raw_bits() & 0x7fff_ffff).wrapping_sub(0x3980_0000) < 0x0948_0000
}

/// Sine of an angle in rad, however large; within 1 ulp. ±0 gives ±0; ±∞ and NaN give NaN.
#[function]
pub fn sinf(x: f32) -> f32 {
    if is_moderate(x) { sine_of_steps(stepped(x), SINE_ROW) } else { far_sine(x) }
}

/// Cosine of an angle in rad, however large; within 1 ulp. ±0 gives 1; ±∞ and NaN give NaN.
#[function]
pub fn cosf(x: f32) -> f32 {
    if x.abs() <= FEW_STEPS { sine_of_steps(stepped(x), COSINE_ROW) } else { far_cosine(x) }
}

/// Sine and cosine of an angle in rad, with the bits of [`sinf`] and [`cosf`] and one reduction.
#[function]
pub fn sin_cosf(x: f32) -> (f32, f32) {
    if is_moderate(x) {
        let angle = stepped(x);
        return (sine_of_steps(angle, SINE_ROW), sine_of_steps(angle, COSINE_ROW));
    }
    if x.abs() < TINY {
        return (x, 1.0);
    }
    if x.abs() > f32::MAX || x.is_nan() {
        return (f32::NAN, f32::NAN);
    }
    let angle = stepped_far(x);
    (sine_of_steps(angle, SINE_ROW), sine_of_steps(angle, COSINE_ROW))
}
