//! Sine and cosine: polynomials of the angle reduced to −π/4 to π/4, exchanged and negated by the quadrant. Together they
//! have one branch that depends on it.

use super::super::RawBits as _;
use super::super::tables::{NARROW_COSINE, NARROW_SINE};
use super::reduction::{ReducedF32, reduced_far, reduced_near};
use crate::prelude::*;

/// Returns true if an angle is below 2⁸ rad, by one comparison: the bits of floats have the order of the floats.
#[inline]
#[function]
fn is_near(x: f32) -> bool {
    (x.raw_bits() & 0x7fff_ffff) < 0x4380_0000
}

/// Sine of a reduced angle in quadrant 0.
#[inline]
#[function]
fn near_sine(angle: ReducedF32) -> f32 {
    let z = angle.high * angle.high;
    let curve = z * (NARROW_SINE[0] + z * (NARROW_SINE[1] + z * NARROW_SINE[2]));
    // A difference of two numbers with the sign of the angle: −0 stays −0.
    angle.high - (angle.high * curve - angle.low)
}

/// Cosine of a reduced angle in quadrant 0.
#[inline]
#[function]
fn near_cosine(angle: ReducedF32) -> f32 {
    let z = angle.high * angle.high;
    let curve = z * (z * (NARROW_COSINE[0] + z * (NARROW_COSINE[1] + z * NARROW_COSINE[2])));
    // 1 − z/2 in two sums, of which the first is exact from z = 1/4 on.
    0.75 + (0.5 * (0.5 - z) + (curve - angle.high * angle.low))
}

/// Sine of a reduced angle, `quadrants` · π/2 further.
#[inline]
#[function]
fn sine_of(angle: ReducedF32, quadrants: u32) -> f32 {
    let quadrant = angle.quadrant.wrapping_add(quadrants);
    let value = if (quadrant & 1) == 0 { near_sine(angle) } else { near_cosine(angle) };
    if (quadrant & 2) == 0 { value } else { -value }
}

/// Sine and cosine of a reduced angle.
#[inline]
#[function]
fn rotated(angle: ReducedF32) -> (f32, f32) {
    let mut sine = near_sine(angle);
    let mut cosine = near_cosine(angle);
    if (angle.quadrant & 1) != 0 {
        let exchanged = cosine;
        cosine = -sine;
        sine = exchanged;
    }
    if (angle.quadrant & 2) != 0 {
        sine = -sine;
        cosine = -cosine;
    }
    (sine, cosine)
}

/// Sine of an angle of 2⁸ rad or more, `quadrants` · π/2 further.
#[inline(never)]
#[function]
pub fn far_sine(x: f32, quadrants: u32) -> f32 {
    sine_of(reduced_far(x), quadrants)
}

/// Sine and cosine of an angle of 2⁸ rad or more.
#[inline(never)]
#[function]
pub fn far_sin_cos(x: f32) -> (f32, f32) {
    rotated(reduced_far(x))
}

/// Sine of an angle in rad, however large; within 1 ulp. ±0 gives ±0; ±∞ and NaN give NaN.
#[function]
pub fn sinf(x: f32) -> f32 {
    if is_near(x) { sine_of(reduced_near(x), 0) } else { far_sine(x, 0) }
}

/// Cosine of an angle in rad, however large; within 1 ulp. ±0 gives 1; ±∞ and NaN give NaN.
#[function]
pub fn cosf(x: f32) -> f32 {
    if is_near(x) { sine_of(reduced_near(x), 1) } else { far_sine(x, 1) }
}

/// Sine and cosine of an angle in rad, with the bits of [`sinf`] and [`cosf`] and one reduction.
#[function]
pub fn sin_cosf(x: f32) -> (f32, f32) {
    if is_near(x) { rotated(reduced_near(x)) } else { far_sin_cos(x) }
}
