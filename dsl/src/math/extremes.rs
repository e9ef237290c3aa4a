//! Powers outside the common path: of negative numbers, zero and infinity, and those that overflow. They are in a
//! separate file so that a compiler does not inline them into the common path.

// A NaN goes the way of what is not less.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use super::exponential::far;
use crate::prelude::*;

/// x^y for a negative x, from `value` = |x|^y.
#[function]
pub fn power_of_negative(value: f64, y: f64) -> f64 {
    // From 2⁵³ on, every number is even.
    if y.abs() >= 9_007_199_254_740_992.0 {
        value
    } else if y.floor() < y {
        f64::NAN
    } else if (0.5 * y).floor() < 0.5 * y {
        -value
    } else {
        value
    }
}

/// x^y where x is zero, infinite or NaN, or y is infinite or NaN.
#[function]
pub fn special_power(x: f64, y: f64) -> f64 {
    if y.abs() <= 0.0 || (x - 1.0).abs() <= 0.0 {
        return 1.0;
    }
    let size = x.abs();
    // False for NaN.
    if !(size <= f64::INFINITY && y.abs() <= f64::INFINITY) {
        return f64::NAN;
    }
    if (size - 1.0).abs() <= 0.0 {
        return 1.0;
    }
    let value = if (size > 1.0) == (y > 0.0) { f64::INFINITY } else { 0.0 };
    // Of zero and infinity, an uneven power keeps the sign; others are positive, whole or not.
    let half = 0.5 * y;
    let odd = y.abs() < 9_007_199_254_740_992.0 && y.floor() >= y && half.floor() < half;
    if odd && 1.0_f64.copysign(x) < 0.0 { -value } else { value }
}

/// x^y = e^(`high` + `low`) times the sign, for results that may overflow or be subnormal, and for a y that is not
/// finite.
#[function]
pub fn far_power(x: f64, y: f64, high: f64, low: f64) -> f64 {
    if !(y.abs() <= f64::MAX) {
        return special_power(x, y);
    }
    let value = far(high, low, 0);
    if x > 0.0 { value } else { power_of_negative(value, y) }
}
