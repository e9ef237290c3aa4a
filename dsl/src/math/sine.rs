//! Sine and cosine.
//!
//! Reduction to a quarter turn after Cody and Waite, *Software Manual for the Elementary Functions*
//! (1980), with π/2 in three parts; then the Taylor polynomials, whose truncation stays under 0.03
//! ulp on ±π/4.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_4};

use crate::prelude::*;

/// The leading 33 bits of π/2: a multiple of it by up to 2²⁰ is exact.
const QUARTER_TURN_HIGH: f64 = f64::from_bits(0x3ff9_21fb_5440_0000);
/// The next 33 bits of π/2.
const QUARTER_TURN_MIDDLE: f64 = f64::from_bits(0x3dd0_b461_1a60_0000);
/// The rest of π/2.
const QUARTER_TURN_LOW: f64 = f64::from_bits(0x3ba3_198a_2e03_7073);

/// A reduction takes off 20 bits at least, so no double needs more.
const PASSES: u32 = 54;

/// An angle as quarter turns and what is left.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReducedAngle {
    /// What is left, rad, −π/4 to π/4.
    pub rest: f64,
    /// Quarter turns modulo four: 0, 1, 2 or 3.
    pub quadrant: f64,
}

/// Takes whole quarter turns off `x`, rad.
#[function]
pub fn reduced_angle(x: f64) -> ReducedAngle {
    let mut rest = x;
    let mut quadrant = 0.0;
    for _ in 0..PASSES {
        // False for NaN: an infinite angle ends as NaN.
        if rest.abs() > FRAC_PI_4 {
            let turns = (rest * FRAC_2_PI + 0.5).floor();
            let high = rest - turns * QUARTER_TURN_HIGH;
            rest = (high - turns * QUARTER_TURN_MIDDLE) - turns * QUARTER_TURN_LOW;
            quadrant += turns - 4.0 * (turns * 0.25).floor();
        } else {
            break;
        }
    }
    ReducedAngle { rest, quadrant: quadrant - 4.0 * (quadrant * 0.25).floor() }
}

/// Sine of −π/4 to π/4 rad.
#[function]
pub fn sine_of_rest(x: f64) -> f64 {
    const S3: f64 = -1.0 / 6.0;
    const S5: f64 = 1.0 / 120.0;
    const S7: f64 = -1.0 / 5_040.0;
    const S9: f64 = 1.0 / 362_880.0;
    const S11: f64 = -1.0 / 39_916_800.0;
    const S13: f64 = 1.0 / 6_227_020_800.0;
    const S15: f64 = -1.0 / 1_307_674_368_000.0;
    const S17: f64 = 1.0 / 355_687_428_096_000.0;
    let z = x * x;
    let high = S11 + z * (S13 + z * (S15 + z * S17));
    let tail = S3 + z * (S5 + z * (S7 + z * (S9 + z * high)));
    // A zero keeps its sign.
    if x == 0.0 { x } else { x + x * z * tail }
}

/// Cosine of −π/4 to π/4 rad.
#[function]
pub fn cosine_of_rest(x: f64) -> f64 {
    const C4: f64 = 1.0 / 24.0;
    const C6: f64 = -1.0 / 720.0;
    const C8: f64 = 1.0 / 40_320.0;
    const C10: f64 = -1.0 / 3_628_800.0;
    const C12: f64 = 1.0 / 479_001_600.0;
    const C14: f64 = -1.0 / 87_178_291_200.0;
    const C16: f64 = 1.0 / 20_922_789_888_000.0;
    let z = x * x;
    let high = C10 + z * (C12 + z * (C14 + z * C16));
    let tail = C4 + z * (C6 + z * (C8 + z * high));
    // 1 − z/2 is rounded once; what the rounding took comes back with the tail.
    let half = 0.5 * z;
    let lead = 1.0 - half;
    lead + (((1.0 - lead) - half) + z * z * tail)
}

/// Sine of an angle in rad.
#[function]
pub fn sin(x: f64) -> f64 {
    let angle = reduced_angle(x);
    if angle.quadrant == 0.0 {
        sine_of_rest(angle.rest)
    } else if angle.quadrant == 1.0 {
        cosine_of_rest(angle.rest)
    } else if angle.quadrant == 2.0 {
        -sine_of_rest(angle.rest)
    } else {
        -cosine_of_rest(angle.rest)
    }
}

/// Cosine of an angle in rad.
#[function]
pub fn cos(x: f64) -> f64 {
    let angle = reduced_angle(x);
    if angle.quadrant == 0.0 {
        cosine_of_rest(angle.rest)
    } else if angle.quadrant == 1.0 {
        -sine_of_rest(angle.rest)
    } else if angle.quadrant == 2.0 {
        -cosine_of_rest(angle.rest)
    } else {
        sine_of_rest(angle.rest)
    }
}
