//! Elementary functions of `f32` in fewer instructions than [`math`](crate::math)'s, with a larger error that is stated.
//!
//! They are ordinary functions of the DSL, so a call shows in the source where accuracy was exchanged for time, and every
//! leg computes the same bits. They use neither `f64` nor 64-bit integers, and only `atan2` has a branch: an argument outside
//! the stated domain returns a number without meaning, and never a fault. `docs/mathematics.md` has the measured errors.
//!
//! # Example
//!
//! ```
//! use bessemer::fast;
//!
//! let (sine, cosine) = fast::sin_cos(0.7);
//! assert!((sine - 0.644_217_7).abs() < 7.5e-8 && (cosine - 0.764_842_2).abs() < 7.5e-8);
//! ```

use crate::math::RawBits as _;
use crate::math::narrow::TO_INTEGER;
use crate::math::narrow::exponential::TO_STEPS;
use crate::math::tables::{
    ANGLE_SINES, ANGLE_STEP_HIGH, ANGLE_STEP_LOW, ANGLE_STEPS, ARCTANGENT_OF_RATIO, NARROW_OF_TWO,
};
use crate::prelude::*;
use core::f32::consts::{FRAC_PI_2, LN_2, LOG2_E, PI};

/// An angle as a multiple of π/64 and a rest of at most half of that.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FastAngle {
    /// Sine of the multiple.
    pub sine: f32,
    /// Cosine of the multiple.
    pub cosine: f32,
    /// Sine of the rest.
    pub rest: f32,
    /// 1 minus the cosine of the rest.
    pub lost: f32,
}

/// Divides an angle in rad into a multiple of π/64 and a rest.
#[inline]
#[function]
pub fn stepped(x: f32) -> FastAngle {
    let shifted = x * ANGLE_STEPS + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let row = (shifted.raw_bits() & 127) as usize;
    let rest = (x - steps * ANGLE_STEP_HIGH) - steps * ANGLE_STEP_LOW;
    let square = rest * rest;
    FastAngle {
        sine: ANGLE_SINES[row],
        cosine: ANGLE_SINES[row + 32],
        rest: rest - rest * (square * (1.0 / 6.0)),
        lost: square * 0.5,
    }
}

/// Sine of an angle from −100 to 100 rad, within 7.5e-8; to 10 000 rad within 5e-4. ±∞ and NaN give NaN.
#[inline]
#[function]
pub fn sin(x: f32) -> f32 {
    let angle = stepped(x);
    angle.sine + (angle.rest * angle.cosine - angle.sine * angle.lost)
}

/// Cosine of an angle from −100 to 100 rad, within 7.5e-8; to 10 000 rad within 5e-4. ±∞ and NaN give NaN.
#[inline]
#[function]
pub fn cos(x: f32) -> f32 {
    let angle = stepped(x);
    angle.cosine - (angle.rest * angle.sine + angle.cosine * angle.lost)
}

/// Sine and cosine of an angle in rad, with the bits of [`sin`] and [`cos`], for a fifth more instructions than one of
/// them.
#[inline]
#[function]
pub fn sin_cos(x: f32) -> (f32, f32) {
    let angle = stepped(x);
    (
        angle.sine + (angle.rest * angle.cosine - angle.sine * angle.lost),
        angle.cosine - (angle.rest * angle.sine + angle.cosine * angle.lost),
    )
}

/// e^x for x from −10 to 10, within 6e-7 of the result relatively; to ±87 within 4.5e-6. ±∞ and NaN give NaN.
#[inline]
#[function]
pub fn exp(x: f32) -> f32 {
    let shifted = x * LOG2_E + TO_STEPS;
    let rest = x - (shifted - TO_STEPS) * LN_2;
    let steps = shifted.raw_bits();
    let row = (steps & 127) as usize;
    let power = f32::from_bits(NARROW_OF_TWO[row][1].wrapping_add(steps << 16));
    power + power * (rest * (1.0 + 0.5 * rest))
}

/// The angle of the point (`x`, `y`) in rad, −π to π, within 6e-7 for coordinates of which the larger is from 1e-30 to
/// 1e38. A `y` of either zero is above the axis: (0, −1) gives π, (0, 0) gives 0. NaN gives NaN.
#[inline]
#[function]
pub fn atan2(y: f32, x: f32) -> f32 {
    let (width, height) = (x.abs(), y.abs());
    let is_steep = height > width;
    let low = if is_steep { width } else { height };
    let high = if is_steep { height } else { width };
    // The smallest normal number makes the ratio of two zeros 0; it changes no other one within the stated range.
    let ratio = low / (high + f32::MIN_POSITIVE);
    let z = ratio * ratio;
    let upper = ARCTANGENT_OF_RATIO[4] + z * (ARCTANGENT_OF_RATIO[5] + z * ARCTANGENT_OF_RATIO[6]);
    let middle = ARCTANGENT_OF_RATIO[2] + z * (ARCTANGENT_OF_RATIO[3] + z * upper);
    let series = ARCTANGENT_OF_RATIO[0] + z * (ARCTANGENT_OF_RATIO[1] + z * middle);
    let flat = ratio + ratio * (z * series);
    let quarter = if is_steep { FRAC_PI_2 - flat } else { flat };
    let half = if x < 0.0 { PI - quarter } else { quarter };
    if y < 0.0 { -half } else { half }
}
