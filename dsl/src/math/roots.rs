//! The cube root and the length of two coordinates.

use super::exponential::power_of_two;
use super::pair::{Pair, product, root, sum};
use super::tables::{ROOT_0, ROOT_1, ROOT_2};
use crate::prelude::*;

/// The cube root: a parabola, two steps of Halley's method, and one of Newton's in two doubles.
#[function]
pub fn cbrt(x: f64) -> f64 {
    let size = x.abs();
    if !(size > 0.0 && size <= f64::MAX) {
        return x;
    }
    // By 2⁵⁴ below the normal numbers.
    let subnormal = size < f64::MIN_POSITIVE;
    let bits = if subnormal { (size * 18_014_398_509_481_984.0).to_bits() } else { size.to_bits() };
    let bias = if subnormal { 1023 + 54 } else { 1023 };
    // Three times 400, to divide what is positive; 1023 is divisible by 3.
    let exponent = ((bits >> 52) & 0x7ff) as u32 + 1200 - bias;
    let third = exponent / 3;
    let mantissa = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000)
        * power_of_two((exponent % 3) as i32);

    let mut guess = ROOT_0 + mantissa * (ROOT_1 + mantissa * ROOT_2);
    for _ in 0..2 {
        let cube = guess * guess * guess;
        guess *= (cube + 2.0 * mantissa) / (2.0 * cube + mantissa);
    }
    let square = product(guess, guess);
    let cube = product(square.high, guess);
    let rest = (mantissa - cube.high) - (cube.low + square.low * guess);
    let value = guess + rest / (3.0 * square.high);
    (value * power_of_two((third as i32).wrapping_sub(400))).copysign(x)
}

/// √(x² + y²), without overflow on the way.
#[function]
pub fn hypot(x: f64, y: f64) -> f64 {
    let width = x.abs();
    let height = y.abs();
    if width > f64::MAX || height > f64::MAX {
        return f64::INFINITY;
    }
    // False for NaN.
    if !(width <= f64::MAX && height <= f64::MAX) {
        return f64::NAN;
    }
    let large = if width > height { width } else { height };
    let small = if width > height { height } else { width };
    // By 2⁻⁶⁰ the smaller is lost.
    if small <= large * 8.673617379884035e-19 {
        return large + small;
    }
    // By 2^±600 where squares leave the range.
    let down = large > 1e150;
    let up = small < 1e-130;
    let scale = if down {
        2.409919865102884e-181
    } else if up {
        4.149515568880993e180
    } else {
        1.0
    };
    let back = if down {
        4.149515568880993e180
    } else if up {
        2.409919865102884e-181
    } else {
        1.0
    };
    let long = product(large * scale, large * scale);
    let short = product(small * scale, small * scale);
    let lead = sum(long.high, short.high);
    let length = root(Pair { high: lead.high, low: lead.low + (long.low + short.low) });
    (length.high + length.low) * back
}
