//! Powers.
//!
//! x^y = e^(y · ln x) with the logarithm and the product in two doubles; special values as C99
//! Annex F has them. Integer powers are products by squaring, in the order that [`powi`] states.

use super::RawBits as _;
use super::exponential::{NORMAL, exponential_of_pair, far_exponential, step};
use super::logarithm::logarithm;
use super::pair::Pair;
use crate::prelude::*;

/// The upper half of a double.
const UPPER: u64 = 0xffff_ffff_0000_0000;

/// y · ln `size` in two doubles, for a finite `size` above zero and |y| up to 2⁶⁵.
#[inline]
#[function]
pub fn exponent_of_power(size: f64, y: f64) -> Pair {
    let logarithm = logarithm(size);
    // 21 bits each: their product is exact.
    let upper = f64::from_bits(logarithm.high.raw_bits() & UPPER);
    let y_upper = f64::from_bits(y.raw_bits() & UPPER);
    let lower = (logarithm.high - upper) + logarithm.low;
    Pair { high: y_upper * upper, low: (y - y_upper) * upper + y * lower }
}

/// What x^y is for a negative x of which `value` is |x|^y.
#[function]
pub fn power_of_negative(value: f64, y: f64) -> f64 {
    // From 2⁵³ on, every number is even.
    if y.abs() >= 9_007_199_254_740_992.0 {
        value
    } else if y.floor() != y {
        f64::NAN
    } else if (0.5 * y).floor() == 0.5 * y {
        value
    } else {
        -value
    }
}

/// x^y where x is zero, infinite or NaN, or |y| is 2⁶⁴ or more, or y is NaN.
#[function]
pub fn special_power(x: f64, y: f64) -> f64 {
    if y == 0.0 || x == 1.0 {
        return 1.0;
    }
    let size = x.abs();
    // False for NaN.
    if !(size <= f64::INFINITY && y.abs() <= f64::INFINITY) {
        return f64::NAN;
    }
    if size == 1.0 {
        return 1.0;
    }
    let value = if (size > 1.0) == (y > 0.0) { f64::INFINITY } else { 0.0 };
    // Of zero and infinity, an uneven power keeps the sign; others are positive, whole or not.
    let half = 0.5 * y;
    let odd = y.abs() < 9_007_199_254_740_992.0 && y.floor() == y && half.floor() != half;
    if odd && 1.0_f64.copysign(x) < 0.0 { -value } else { value }
}

/// x^y.
#[function]
pub fn powf(x: f64, y: f64) -> f64 {
    let size = x.abs();
    // 2⁶⁴: above, any other base than 1 leaves the range. False for NaN.
    if size > 0.0 && size <= f64::MAX && y.abs() < 18_446_744_073_709_551_616.0 {
        let exponent = exponent_of_power(size, y);
        let value = if exponent.high.abs() < NORMAL {
            let power = exponential_of_pair(exponent.high, exponent.low);
            let lead = step(power.steps);
            lead + lead * power.rest
        } else {
            far_exponential(exponent.high, exponent.low, 0)
        };
        if x > 0.0 { value } else { power_of_negative(value, y) }
    } else {
        special_power(x, y)
    }
}

/// x^n by squaring: with b = x, for each binary digit of |n| from the last on, the result, which
/// starts as 1, is multiplied by b if the digit is 1, and then b by itself; for a negative n, 1
/// divided by that.
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
