//! Powers.
//!
//! x^y = e^(y · ln x) with the logarithm and the product in two doubles; special values as C99
//! Annex F has them. Integer powers are products by squaring, in the order that [`powi`] states.

use super::exponential::{exponential, rounded};
use super::logarithm::logarithm;
use super::pair::product;
use crate::prelude::*;

/// `size`^`y` for a `size` of zero or more and not NaN, and `y` not zero and not NaN.
#[function]
pub fn power_of_size(size: f64, y: f64) -> f64 {
    // 2⁶⁴: above, any other base than 1 leaves the range.
    const LARGE: f64 = 18_446_744_073_709_551_616.0;
    if size == 1.0 {
        1.0
    } else if y.abs() > LARGE || size == 0.0 || size > f64::MAX {
        if (size > 1.0) == (y > 0.0) { f64::INFINITY } else { 0.0 }
    } else {
        let logarithm = logarithm(size);
        let lead = product(y, logarithm.high);
        if lead.high > 750.0 {
            f64::INFINITY
        } else if lead.high < -750.0 {
            0.0
        } else {
            rounded(exponential(lead.high, lead.low + y * logarithm.low))
        }
    }
}

/// x^y.
#[function]
pub fn powf(x: f64, y: f64) -> f64 {
    if y == 0.0 || x == 1.0 {
        return 1.0;
    }
    let size = x.abs();
    // False for NaN.
    if !(size <= f64::INFINITY && y.abs() <= f64::INFINITY) {
        return f64::NAN;
    }
    let value = power_of_size(size, y);
    if 1.0_f64.copysign(x) > 0.0 {
        return value;
    }
    // From 2⁵³ on, every number is even.
    let large = y.abs() >= 9_007_199_254_740_992.0;
    let integer = large || y.floor() == y;
    let half = 0.5 * y;
    if integer && !large && half.floor() != half {
        -value
    } else if integer || size == 0.0 || size > f64::MAX {
        value
    } else {
        f64::NAN
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
