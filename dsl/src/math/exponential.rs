//! The exponential functions.
//!
//! After P. T. P. Tang, *Table-driven implementation of the exponential function* (ACM TOMS 15,
//! 1989): e^x = 2^k · 2^(j/64) · e^r with |r| ≤ (ln 2)/128, the middle factor from a table in two
//! doubles, the last from its Taylor polynomial. The result is rounded once, below the normal
//! numbers too.

use core::f64::consts::LN_2;

use super::pair::sum;
use super::tables::{POWER_HIGH, POWER_LOW, STEP_HIGH, STEP_LOW, STEPS_PER_UNIT};
use crate::prelude::*;

/// 1.5 · 2⁵²: added to a smaller number it leaves the nearest integer in the last bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

const E2: f64 = 1.0 / 2.0;
const E3: f64 = 1.0 / 6.0;
const E4: f64 = 1.0 / 24.0;
const E5: f64 = 1.0 / 120.0;
const E6: f64 = 1.0 / 720.0;
const E7: f64 = 1.0 / 5_040.0;
const E8: f64 = 1.0 / 40_320.0;
const E9: f64 = 1.0 / 362_880.0;
const E10: f64 = 1.0 / 3_628_800.0;
const E11: f64 = 1.0 / 39_916_800.0;

/// A positive number, the sum of two doubles times a power of two.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scaled {
    /// The leading part, 1 to 2.
    pub high: f64,
    /// What is added to it.
    pub low: f64,
    /// The exponent of the power of two.
    pub exponent: i32,
}

/// Two to a power from −1022 to 1023.
#[function]
pub fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits((exponent.wrapping_add(1023) as u64) << 52)
}

/// The number, rounded once.
#[function]
pub fn rounded(number: Scaled) -> f64 {
    let value = number.high + number.low;
    let exponent = number.exponent;
    if exponent > 1023 {
        // 2¹⁰²³
        let half = value * 8.98846567431158e307;
        if exponent > 1024 { f64::INFINITY } else { half * 2.0 }
    } else if exponent > -1022 || (exponent == -1022 && value >= 1.0) {
        value * power_of_two(exponent)
    } else if exponent < -1080 {
        0.0
    } else {
        // Beside this one, the last place is that of the smallest number.
        let large = power_of_two((-1022_i32).wrapping_sub(exponent));
        let lead = large + number.high;
        let total = lead + (((large - lead) + number.high) + number.low);
        // By 2²⁰⁰ and back: neither step rounds.
        (total - large) * power_of_two(exponent.wrapping_add(200)) * 6.223015277861142e-61
    }
}

/// 2^(`steps`/64) · e^`r` for |r| ≤ (ln 2)/128; `shifted` has the integer `steps` in its last bits.
#[function]
pub fn step_power(shifted: u64, r: f64) -> Scaled {
    let index = (shifted & 63) as usize;
    let tail = E2 + r * (E3 + r * (E4 + r * (E5 + r * E6)));
    let near = r + r * r * tail;
    let lead = POWER_HIGH[index];
    Scaled {
        high: lead,
        low: POWER_LOW[index] + lead * near,
        // 14 bits, signed.
        exponent: (((shifted >> 6) & 0x3fff) as i32 ^ 0x2000).wrapping_sub(0x2000),
    }
}

/// e^(`high` + `low`) for −750 to 750, before its last rounding.
#[function]
pub fn exponential(high: f64, low: f64) -> Scaled {
    let shifted = high * STEPS_PER_UNIT + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let r = (high - steps * STEP_HIGH) - (steps * STEP_LOW - low);
    step_power(shifted.to_bits(), r)
}

/// e^x.
#[function]
pub fn exp(x: f64) -> f64 {
    if x.abs() <= 750.0 {
        rounded(exponential(x, 0.0))
    } else if x > 0.0 {
        f64::INFINITY
    } else if x < 0.0 {
        0.0
    } else {
        x
    }
}

/// 2^x.
#[function]
pub fn exp2(x: f64) -> f64 {
    if x.abs() <= 1080.0 {
        let shifted = x * 64.0 + TO_INTEGER;
        let r = (x - (shifted - TO_INTEGER) * 0.015625) * LN_2;
        rounded(step_power(shifted.to_bits(), r))
    } else if x > 0.0 {
        f64::INFINITY
    } else if x < 0.0 {
        0.0
    } else {
        x
    }
}

/// e^x − 1, without cancellation.
#[function]
pub fn exp_m1(x: f64) -> f64 {
    let size = x.abs();
    // 2⁻⁵⁴
    if size < 5.551115123125783e-17 {
        x
    } else if size < 0.125 {
        let upper = E7 + x * (E8 + x * (E9 + x * (E10 + x * E11)));
        let tail = E3 + x * (E4 + x * (E5 + x * (E6 + x * upper)));
        // x²/2 is the larger part of what is added.
        x + (E2 * x * x + x * x * x * tail)
    } else if x < -40.0 {
        -1.0
    } else if x <= 40.0 {
        let power = exponential(x, 0.0);
        let scale = power_of_two(power.exponent);
        let lead = sum(power.high * scale, -1.0);
        lead.high + (lead.low + power.low * scale)
    } else {
        exp(x)
    }
}
