//! Powers.
//!
//! x^y = e^(y · ln x), with the logarithm and the product in two doubles; special values are those of C99, Annex F.
//! Integer powers are products by squaring, from the last binary digit of the exponent on.

// A NaN goes the way of what is not less.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use super::RawBits as _;
use super::exponential::{NORMAL, power_of_pair, step};
use super::extremes::{far_power, power_of_negative, special_power};
use super::logarithm::{logarithm, parts};
use super::pair::UPPER;
use crate::prelude::*;

/// x^y; measured within 0.51 ulp. `y` = ±0 and `x` = 1 give 1; a negative x gives NaN unless y is a whole number;
/// otherwise as in C99, F.9.4.4.
#[function]
pub fn powf(x: f64, y: f64) -> f64 {
    let size = x.abs();
    let raw = size.raw_bits();
    if size > 0.0 && raw < 0x7ff0_0000_0000_0000 {
        // By 2⁵⁴ below the normal numbers.
        let small = raw < 0x0010_0000_0000_0000;
        let bits = if small { (size * 18_014_398_509_481_984.0).raw_bits() } else { raw };
        let parts = parts(bits);
        let exponent = if small { parts.exponent.wrapping_sub(54) } else { parts.exponent };
        let logarithm = logarithm(parts, exponent as f64);

        // 21 bits each: their product is exact.
        let upper = f64::from_bits(logarithm.high.raw_bits() & UPPER);
        let y_upper = f64::from_bits(y.raw_bits() & UPPER);
        let lower = (logarithm.high - upper) + logarithm.low;
        let high = y_upper * upper;
        let low = (y - y_upper) * upper + y * lower;
        if !(high.abs() < NORMAL) {
            return far_power(x, y, high, low);
        }
        let power = power_of_pair(high, low);
        let lead = step(power.steps);
        let value = lead + lead * power.rest;
        if x > 0.0 {
            return value;
        }
        return power_of_negative(value, y);
    }
    special_power(x, y)
}

/// x^n by squaring.
///
/// The result is 1 at first, and b = x. For each binary digit of |n|, from the last on, the result is multiplied by b
/// if the digit is 1, and then b by itself; for a negative n, the result is 1 divided by that.
#[function]
pub fn powi(x: f64, n: i32) -> f64 {
    let mut digits = if n < 0 { 0u32.wrapping_sub(n as u32) } else { n as u32 };
    let mut result = 1.0;
    let mut base = x;
    for _ in 0..32 {
        if digits == 0 {
            break;
        }
        if (digits & 1) == 1 {
            result *= base;
        }
        base *= base;
        digits >>= 1;
    }
    if n < 0 { 1.0 / result } else { result }
}
