//! Sine and cosine: the angle reduced to a quarter turn, and a short polynomial.

use super::super::RawBits as _;
use super::super::tables::{NARROW_COSINE, NARROW_SINE};
use super::reduction::{ReducedF32, reduced_angle};
use crate::prelude::*;

/// Below this an angle is its own sine and tangent: 2⁻¹².
#[crate::data]
pub(crate) const TINY: f32 = 2.4414063e-4;

/// Sine of `high` + `low` for −π/4 to π/4.
#[inline]
#[function]
fn near_sine(high: f32, low: f32) -> f32 {
    let z = high * high;
    let tail = NARROW_SINE[0] + z * (NARROW_SINE[1] + z * NARROW_SINE[2]);
    // The slope is the cosine.
    high + (low * (1.0 - 0.5 * z) + high * z * tail)
}

/// Cosine of `high` + `low` for −π/4 to π/4.
#[inline]
#[function]
fn near_cosine(high: f32, low: f32) -> f32 {
    let z = high * high;
    let half = 0.5 * z;
    let lead = 1.0 - half;
    let curve = z * z * (NARROW_COSINE[0] + z * (NARROW_COSINE[1] + z * NARROW_COSINE[2]));
    lead + (((1.0 - lead) - half) + (curve - high * low))
}

/// Sine of a reduced angle + `quarter_turns` · π/2.
#[inline]
#[function]
fn turned(angle: ReducedF32, quarter_turns: u32) -> f32 {
    let quadrant = angle.quadrant.wrapping_add(quarter_turns);
    let value = if (quadrant & 1) == 0 {
        near_sine(angle.high, angle.low)
    } else {
        near_cosine(angle.high, angle.low)
    };
    // The second bit of the quadrant is the sign.
    f32::from_bits(value.raw_bits() ^ ((quadrant & 2) << 30))
}

/// Sine of an angle in rad, however large; within 1 ulp. ±0 gives ±0; ±∞ and NaN give NaN.
#[function]
pub fn sinf(x: f32) -> f32 {
    // −0 stays what it is.
    if x.abs() < TINY { x } else { turned(reduced_angle(x), 0) }
}

/// Cosine of an angle in rad, however large; within 1 ulp. ±0 gives 1; ±∞ and NaN give NaN.
#[function]
pub fn cosf(x: f32) -> f32 {
    turned(reduced_angle(x), 1)
}

/// Sine and cosine of an angle in rad: the bits of [`sinf`] and of [`cosf`], with one reduction.
#[function]
pub fn sin_cosf(x: f32) -> (f32, f32) {
    if x.abs() < TINY {
        return (x, 1.0);
    }
    let angle = reduced_angle(x);
    let sine = near_sine(angle.high, angle.low);
    let cosine = near_cosine(angle.high, angle.low);
    let odd = (angle.quadrant & 1) == 1;
    let first = if odd { cosine } else { sine };
    let second = if odd { sine } else { cosine };
    (
        if (angle.quadrant & 2) == 0 { first } else { -first },
        if (angle.quadrant.wrapping_add(1) & 2) == 0 { second } else { -second },
    )
}
