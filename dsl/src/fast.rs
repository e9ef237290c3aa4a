//! Elementary functions of `f32` in fewer instructions than [`math`](crate::math)'s, with a larger error that is stated.
//!
//! They are ordinary functions of the DSL, so a call shows in the source where accuracy was exchanged for time, and every
//! leg computes the same bits. They use neither `f64` nor 64-bit integers, and have no branch: an argument outside the
//! stated domain returns a number without meaning, and never a fault. `docs/mathematics.md` has the measured errors.
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
use crate::math::tables::{ANGLE_SINES, ANGLE_STEP_HIGH, ANGLE_STEP_LOW, ANGLE_STEPS};
use crate::prelude::*;

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
