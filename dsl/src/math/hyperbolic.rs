//! The hyperbolic functions: from e^x and e^(−x), both before their last rounding; near zero, the sine
//! from its Taylor series, and the tangent from sine and cosine.

use super::exponential::{Scaled, exp, exponential, power_of_two, rounded};
use super::pair::{Pair, quotient, sum};
use crate::prelude::*;

const H3: f64 = 1.0 / 6.0;
const H5: f64 = 1.0 / 120.0;
const H7: f64 = 1.0 / 5_040.0;
const H9: f64 = 1.0 / 362_880.0;
const H11: f64 = 1.0 / 39_916_800.0;
const H13: f64 = 1.0 / 6_227_020_800.0;

/// Below this a number is its own hyperbolic sine and tangent: 2⁻²⁷.
const TINY: f64 = 7.450580596923828e-9;
/// From here on e^(−x) is lost beside e^x.
const LARGE: f64 = 22.0;

/// e^x / 2 for −40 to 40, before its last rounding.
#[function]
pub fn half_exponential(x: f64) -> Pair {
    let power = exponential(x, 0.0);
    let scale = power_of_two(power.exponent.wrapping_sub(1));
    Pair { high: power.high * scale, low: power.low * scale }
}

/// e^x / 2 for 22 and more.
#[function]
pub fn large_half_exponential(x: f64) -> f64 {
    if x <= 750.0 {
        let power = exponential(x, 0.0);
        rounded(Scaled {
            high: power.high,
            low: power.low,
            exponent: power.exponent.wrapping_sub(1),
        })
    } else {
        exp(x)
    }
}

/// The hyperbolic sine of 0 to 22, before its last rounding.
#[function]
pub fn hyperbolic_sine(x: f64) -> Pair {
    if x < 0.25 {
        let z = x * x;
        let tail = H3 + z * (H5 + z * (H7 + z * (H9 + z * (H11 + z * H13))));
        Pair { high: x, low: x * z * tail }
    } else {
        let rising = half_exponential(x);
        let falling = half_exponential(-x);
        let lead = sum(rising.high, -falling.high);
        Pair { high: lead.high, low: lead.low + (rising.low - falling.low) }
    }
}

/// The hyperbolic cosine of 0 to 22, before its last rounding.
#[function]
pub fn hyperbolic_cosine(x: f64) -> Pair {
    let rising = half_exponential(x);
    let falling = half_exponential(-x);
    let lead = sum(rising.high, falling.high);
    Pair { high: lead.high, low: lead.low + (rising.low + falling.low) }
}

/// The hyperbolic sine.
#[function]
pub fn sinh(x: f64) -> f64 {
    let size = x.abs();
    if size < TINY {
        return x;
    }
    if size < LARGE {
        let pair = hyperbolic_sine(size);
        (pair.high + pair.low).copysign(x)
    } else {
        large_half_exponential(size).copysign(x)
    }
}

/// The hyperbolic cosine.
#[function]
pub fn cosh(x: f64) -> f64 {
    let size = x.abs();
    if size < LARGE {
        let pair = hyperbolic_cosine(size);
        pair.high + pair.low
    } else {
        large_half_exponential(size)
    }
}

/// The hyperbolic tangent.
#[function]
pub fn tanh(x: f64) -> f64 {
    let size = x.abs();
    if size < TINY {
        x
    } else if size < LARGE {
        quotient(hyperbolic_sine(size), hyperbolic_cosine(size)).high.copysign(x)
    } else if size >= LARGE {
        1.0_f64.copysign(x)
    } else {
        f64::NAN
    }
}
