//! Sine and cosine.
//!
//! Reduction to a quarter turn after Cody and Waite, *Software Manual for the Elementary Functions*
//! (1980), with π/2 in four parts and the rest in two doubles; huge angles go to [`super::reduction`].
//! Then a table of both at multiples of 1/64 and the Taylor polynomials of the 1/128 that is left,
//! after P. T. P. Tang, *Table-lookup algorithms for elementary functions* (ARITH-10, 1991).

use core::f64::consts::FRAC_2_PI;

use super::pair::Pair;
use super::reduction::{ReducedAngle, reduced_huge_angle};
use super::tables::{
    COSINE_HIGH, COSINE_LOW, QUARTER_TURN_1, QUARTER_TURN_2, QUARTER_TURN_3, QUARTER_TURN_4,
    SINE_HIGH, SINE_LOW,
};
use crate::prelude::*;

/// Up to here quarter turns are fewer than 2²⁰, rad.
const MODERATE: f64 = 1_600_000.0;
/// 1.5 · 2⁵²: added to a smaller number it leaves the nearest integer in the last bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// Below this an angle is its own sine and tangent: 2⁻²⁷.
const TINY: f64 = 7.450580596923828e-9;

const S3: f64 = -1.0 / 6.0;
const S5: f64 = 1.0 / 120.0;
const S7: f64 = -1.0 / 5_040.0;
const S9: f64 = 1.0 / 362_880.0;
const S11: f64 = -1.0 / 39_916_800.0;
const C2: f64 = -1.0 / 2.0;
const C4: f64 = 1.0 / 24.0;
const C6: f64 = -1.0 / 720.0;

/// Takes whole quarter turns off `x`, rad.
#[function]
pub fn reduced_angle(x: f64) -> ReducedAngle {
    let size = x.abs();
    if size <= MODERATE {
        let shifted = x * FRAC_2_PI + TO_INTEGER;
        let turns = shifted - TO_INTEGER;
        // Three products without loss; what the two differences lose is kept.
        let first = x - turns * QUARTER_TURN_1;
        let part = turns * QUARTER_TURN_2;
        let second = first - part;
        let taken = first - second;
        let lost = (first - (second + taken)) + (taken - part);
        let part = turns * QUARTER_TURN_3;
        let third = second - part;
        let taken = second - third;
        let lost = lost + ((second - (third + taken)) + (taken - part));
        let rest = lost - turns * QUARTER_TURN_4;
        let high = third + rest;
        ReducedAngle { high, low: rest - (high - third), quadrant: shifted.to_bits() & 3 }
    } else if size <= f64::MAX {
        reduced_huge_angle(x)
    } else {
        ReducedAngle { high: f64::NAN, low: 0.0, quadrant: 0 }
    }
}

/// Sine of −π/4 to π/4 rad, before its last rounding.
#[function]
pub fn sine_of_rest(high: f64, low: f64) -> Pair {
    let size = high.abs();
    if size < 0.125 {
        let z = high * high;
        let tail = S3 + z * (S5 + z * (S7 + z * (S9 + z * S11)));
        Pair { high, low: low + high * z * tail }
    } else {
        let shifted = size * 64.0 + TO_INTEGER;
        let index = (shifted.to_bits() & 63) as usize;
        let left = size - (shifted - TO_INTEGER) * 0.015625;
        let t = if high < 0.0 { left - low } else { left + low };
        let z = t * t;
        let sine = t + t * z * (S3 + z * (S5 + z * S7));
        let versine = z * (C2 + z * (C4 + z * C6));
        let centre = SINE_HIGH[index];
        let rest = SINE_LOW[index] + (COSINE_HIGH[index] * sine + centre * versine);
        if high < 0.0 {
            Pair { high: -centre, low: -rest }
        } else {
            Pair { high: centre, low: rest }
        }
    }
}

/// Cosine of −π/4 to π/4 rad, before its last rounding.
#[function]
pub fn cosine_of_rest(high: f64, low: f64) -> Pair {
    let size = high.abs();
    let shifted = size * 64.0 + TO_INTEGER;
    let index = (shifted.to_bits() & 63) as usize;
    let left = size - (shifted - TO_INTEGER) * 0.015625;
    let t = if high < 0.0 { left - low } else { left + low };
    let z = t * t;
    let sine = t + t * z * (S3 + z * (S5 + z * S7));
    let versine = z * (C2 + z * (C4 + z * C6));
    let centre = COSINE_HIGH[index];
    let rest = COSINE_LOW[index] + (centre * versine - SINE_HIGH[index] * sine);
    Pair { high: centre, low: rest }
}

/// Sine of an angle in rad.
#[function]
pub fn sin(x: f64) -> f64 {
    if x.abs() < TINY {
        return x;
    }
    let angle = reduced_angle(x);
    let pair = if (angle.quadrant & 1) == 0 {
        sine_of_rest(angle.high, angle.low)
    } else {
        cosine_of_rest(angle.high, angle.low)
    };
    let value = pair.high + pair.low;
    if angle.quadrant < 2 { value } else { -value }
}

/// Cosine of an angle in rad.
#[function]
pub fn cos(x: f64) -> f64 {
    let angle = reduced_angle(x);
    let pair = if (angle.quadrant & 1) == 0 {
        cosine_of_rest(angle.high, angle.low)
    } else {
        sine_of_rest(angle.high, angle.low)
    };
    let value = pair.high + pair.low;
    if angle.quadrant == 0 || angle.quadrant == 3 { value } else { -value }
}
