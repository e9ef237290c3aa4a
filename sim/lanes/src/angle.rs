//! Sine and cosine for simulated plants: the same steps for every angle, so that eight angles cost little more than one.
//!
//! The angle is reduced by multiples of π/2 in three parts, after W. J. Cody and W. Waite, *Software Manual for the Elementary
//! Functions* (1980), and both functions of the rest are their Taylor series.

use crate::Number;

/// π/2 in three parts. The first two have 32 bits, so their products with a number of quarters of a turn are exact.
const QUARTER: [f64; 3] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Quarters of a turn in a radian.
const QUARTERS_PER_RADIAN: f64 = core::f64::consts::FRAC_2_PI;

/// A number to which another is added to round it to a whole number: 1.5 · 2⁵².
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;

/// Coefficients of the sine's series, (−1)ⁿ / (2n + 1)!, from the last to the factor of x³.
const SINE: [f64; 7] = [
    -1.0 / 1_307_674_368_000.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 39_916_800.0,
    1.0 / 362_880.0,
    -1.0 / 5_040.0,
    1.0 / 120.0,
    -1.0 / 6.0,
];

/// Coefficients of the cosine's series, (−1)ⁿ / (2n)!, from the last to the factor of x⁴.
const COSINE: [f64; 7] = [
    1.0 / 20_922_789_888_000.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 479_001_600.0,
    -1.0 / 3_628_800.0,
    1.0 / 40_320.0,
    -1.0 / 720.0,
    1.0 / 24.0,
];

/// Returns sine and cosine of an angle, rad.
///
/// The error is at most 2⁻⁵² up to 10⁶ rad; beyond, it grows, and huge angles have no meaningful result. Infinite angles and NaN
/// have NaN.
///
/// ```
/// use bessemer_lanes::{Real, sin_cos};
/// let (sine, cosine) = sin_cos(2.5);
/// assert!((sine - 2.5_f64.sin()).abs() < 2e-16 && (cosine - 2.5_f64.cos()).abs() < 2e-16);
/// assert_eq!(sin_cos(Real::of(2.5)).0.lane(3), sine);
/// ```
#[inline(always)]
pub fn sin_cos<T: Number>(angle: T) -> (T, T) {
    let whole = |value: T| value + T::of(TO_WHOLE) - T::of(TO_WHOLE);
    let quarters = whole(angle * T::of(QUARTERS_PER_RADIAN));
    let [high, middle, low] = QUARTER.map(T::of);
    let rest = angle - quarters * high - quarters * middle - quarters * low;
    let square = rest * rest;
    let series = |coefficients: [f64; 7]| {
        let [first, others @ ..] = coefficients;
        others.iter().fold(T::of(first), |sum, it| sum * square + T::of(*it))
    };
    let sine = rest + rest * square * series(SINE);
    let half = T::of(0.5) * square;
    let near = T::of(1.0) - half;
    // The rounding of `near` is added to what follows.
    let cosine = near + ((T::of(1.0) - near - half) + square * square * series(COSINE));
    // An odd number of quarters exchanges both functions.
    let halves = whole(quarters * T::of(0.5));
    let odd = (quarters - halves * T::of(2.0)).magnitude();
    let exchange = |one: T, other: T| T::of(0.5).below(odd, other, one);
    let sign = |halves: T, value: T| {
        let odd = (halves - whole(halves * T::of(0.5)) * T::of(2.0)).magnitude();
        T::of(0.5).below(odd, -value, value)
    };
    // An odd number of whole halves changes the sign. The cosine is the sine a quarter ahead.
    let below = |quarters: T| whole(quarters * T::of(0.5) - T::of(0.25));
    let sines = sign(below(quarters), exchange(sine, cosine));
    let cosines = sign(below(quarters + T::of(1.0)), exchange(cosine, sine));
    (sines, cosines)
}
