//! The exponential functions.
//!
//! After P. T. P. Tang, *Table-driven implementation of the exponential function* (ACM TOMS 15, 1989): e^x = 2^k ·
//! 2^(j/128) · e^r with |r| ≤ (ln 2)/256. The middle factor comes from a table, with the rounding error of its
//! double, and the last from its Taylor polynomial. Only the last addition rounds visibly, also for subnormal
//! results; the polynomial is off by less than 2⁻⁶⁰, and so is each earlier rounding.
//!
//! Most arguments take four steps: split x, look up the power of two of its steps, add the polynomial of the
//! remainder, and round once. Results that may not be normal numbers take a longer way, with one rounding, too.
//!
//! Up to |x| = 750 the number of steps of (ln 2)/128 is at most 138 499, which fits in 19 bits with its sign. Its
//! product with the leading part of the step is exact: a multiple of 2⁻⁴³ below 1024.

use core::f64::consts::LN_2;

use super::RawBits as _;
use super::pair::sum;
use super::sine::TO_INTEGER;
use super::tables::{EXP_M1, OF_TWO, STEPS_PER_UNIT, UNIT_STEP_HIGH, UNIT_STEP_LOW};
use crate::prelude::*;

/// Coefficient of x² in the Taylor series of e^x. Up to |x| = (ln 2)/256 the terms after the fifth power are below
/// 2⁻⁶⁰.
#[crate::data]
pub(crate) const E2: f64 = 1.0 / 2.0;
/// Coefficient of x³.
#[crate::data]
pub(crate) const E3: f64 = 1.0 / 6.0;
/// Coefficient of x⁴.
#[crate::data]
pub(crate) const E4: f64 = 1.0 / 24.0;
/// Coefficient of x⁵.
#[crate::data]
pub(crate) const E5: f64 = 1.0 / 120.0;
/// Coefficient of x⁶ in the Taylor series of e^x. With it, the omitted terms are below 2⁻⁶¹ up to |x| = (ln 2)/256 +
/// 1/200.
#[crate::data]
pub(crate) const E6: f64 = 1.0 / 720.0;

/// Coefficient of x² in the Taylor series of 2^x. Up to |x| = 1/256 the terms after the fifth power are below 2⁻⁶⁰.
#[crate::data]
const P2: f64 = LN_2 * LN_2 / 2.0;
/// Coefficient of x³.
#[crate::data]
const P3: f64 = LN_2 * LN_2 * LN_2 / 6.0;
/// Coefficient of x⁴.
#[crate::data]
const P4: f64 = LN_2 * LN_2 * LN_2 * LN_2 / 24.0;
/// Coefficient of x⁵.
#[crate::data]
const P5: f64 = LN_2 * LN_2 * LN_2 * LN_2 * LN_2 / 120.0;

/// 1.5 · 2⁴⁵: added to a smaller number it leaves the nearest multiple of 1/128 in the last bits.
#[crate::data]
pub(crate) const TO_STEP: f64 = TO_INTEGER / 128.0;

/// Up to this |x|, e^x and the summands of its last addition are normal numbers. e^−660 is above 2⁻⁹⁵³, its last place
/// above 2⁻¹⁰⁰⁶.
#[crate::data]
pub(crate) const NORMAL: f64 = 660.0;
/// From this |x| on, e^x and its half are ∞ or 0: the largest number is below e^710, half of the smallest above
/// e^−746.
#[crate::data]
const BEYOND: f64 = 750.0;
/// 2¹⁰²³, the largest power of two.
#[crate::data]
const LARGEST_POWER: f64 = 8.98846567431158e307;
/// 2⁻²⁰⁰, the factor that undoes [`RAISED`].
#[crate::data]
const LOWER: f64 = 6.223015277861142e-61;
/// Added to an exponent whose power of two would not be a normal number.
#[crate::data]
const RAISED: i32 = 200;
/// For exponents below this a power is less than half of the smallest number, 2⁻¹⁰⁷⁴, and so rounds to 0.
#[crate::data]
const NOTHING: i32 = -1080;

/// A power of e or 2 before its last rounding: s · (1 + `rest`), where s is the double nearest to 2^(`steps`/128).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Power {
    /// A signed integer in the last 19 bits; the bits above are arbitrary.
    pub steps: u64,
    /// The sum of the rounding error of s and the part of the power beyond 2^(`steps`/128), as a fraction of s.
    pub rest: f64,
}

/// Two to the power of an exponent from −1022 to 1023.
#[inline]
#[function]
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits((exponent.wrapping_add(1023) as u32 as u64) << 52)
}

/// The double nearest to 2^(`steps`/128), where that is a normal number.
#[inline]
#[function]
pub(crate) fn step(steps: u64) -> f64 {
    // The upper half alone changes: one addition where a word has 32 bits.
    let bits = OF_TWO[(steps & 127) as usize][1];
    let upper = ((bits >> 32) as u32).wrapping_add((steps as u32) << 13);
    f64::from_bits(((upper as u64) << 32) | (bits & 0xffff_ffff))
}

/// The rounding error of the double nearest to 2^(`steps`/128), as a fraction of it.
#[inline]
#[function]
pub(crate) fn step_rest(steps: u64) -> f64 {
    f64::from_bits(OF_TWO[(steps & 127) as usize][0])
}

/// 2^(`steps`/128) · e^`r` for |r| ≤ (ln 2)/256.
#[inline]
#[function]
fn step_power(steps: u64, r: f64) -> Power {
    let z = r * r;
    let tail = (E2 + r * E3) + z * (E4 + r * E5);
    Power { steps, rest: (step_rest(steps) + r) + z * tail }
}

/// e^x for x from −750 to 750, before its last rounding.
#[inline]
#[function]
pub(crate) fn power(x: f64) -> Power {
    let shifted = x * STEPS_PER_UNIT + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    step_power(shifted.raw_bits(), (x - steps * UNIT_STEP_HIGH) - steps * UNIT_STEP_LOW)
}

/// e^(`high` + `low`) for `high` from −750 to 750 and |`low`| up to 1/200, before its last rounding.
#[inline]
#[function]
pub(crate) fn power_of_pair(high: f64, low: f64) -> Power {
    let shifted = high * STEPS_PER_UNIT + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let r = ((high - steps * UNIT_STEP_HIGH) - steps * UNIT_STEP_LOW) + low;
    // As for one double, a term longer.
    let z = r * r;
    let tail = (E2 + r * E3) + z * ((E4 + r * E5) + z * E6);
    let bits = shifted.raw_bits();
    Power { steps: bits, rest: (step_rest(bits) + r) + z * tail }
}

/// The rounded power times 2^`more`, which is 1 or ½. The result may be subnormal; only the last addition rounds it.
#[function]
fn rounded(power: Power, more: i32) -> f64 {
    // From 1 to 2.
    let high = f64::from_bits(
        OF_TWO[(power.steps & 127) as usize][1].wrapping_add((power.steps & 127) << 45),
    );
    // 19 bits, signed, without the 7 of the index.
    let whole = (((power.steps & 0x7_ffff) as i32) ^ 0x4_0000).wrapping_sub(0x4_0000) >> 7;
    let exponent = whole.wrapping_add(more);
    let low = high * power.rest;
    let value = high + low;
    if exponent > 1023 {
        // The power of two itself would be no number.
        let half = value * LARGEST_POWER;
        if exponent > 1024 { f64::INFINITY } else { half * 2.0 }
    } else if exponent > -1022 || (exponent == -1022 && value >= 1.0) {
        value * power_of_two(exponent)
    } else if exponent < NOTHING {
        0.0
    } else {
        // Beside this one, the last place is that of the smallest number.
        let large = power_of_two((-1022_i32).wrapping_sub(exponent));
        let lead = large + high;
        let total = lead + (((large - lead) + high) + low);
        // By 2²⁰⁰ and back: neither step rounds.
        (total - large) * power_of_two(exponent.wrapping_add(RAISED)) * LOWER
    }
}

/// e^(x + `low`) · 2^`more` for |x| from 660 on, infinities and NaN; |`low`| is at most 1/200, `more` 0 or −1.
#[function]
pub fn far(x: f64, low: f64, more: i32) -> f64 {
    if x.abs() <= BEYOND {
        rounded(power_of_pair(x, low), more)
    } else if x > 0.0 {
        f64::INFINITY
    } else if x < 0.0 {
        0.0
    } else {
        x
    }
}

/// e^x; measured within 0.51 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn exp(x: f64) -> f64 {
    if x.abs() < NORMAL {
        let power = power(x);
        let lead = step(power.steps);
        lead + lead * power.rest
    } else {
        far(x, 0.0, 0)
    }
}

/// 2^x for x from −1080 to 1080, before its last rounding.
#[inline]
#[function]
fn binary(x: f64) -> Power {
    let shifted = x + TO_STEP;
    let r = x - (shifted - TO_STEP);
    let steps = shifted.raw_bits();
    let z = r * r;
    let tail = (P2 + r * P3) + z * (P4 + r * P5);
    Power { steps, rest: (step_rest(steps) + r * LN_2) + z * tail }
}

/// 2^x for |x| from 960 on, infinities and NaN.
#[function]
pub fn far_power(x: f64) -> f64 {
    if x.abs() <= 1080.0 {
        rounded(binary(x), 0)
    } else if x > 0.0 {
        f64::INFINITY
    } else if x < 0.0 {
        0.0
    } else {
        x
    }
}

/// 2^x; measured within 0.51 ulp. −∞ gives 0, an overflow gives ∞, NaN gives NaN.
#[function]
pub fn exp2(x: f64) -> f64 {
    if x.abs() < 960.0 {
        let power = binary(x);
        let lead = step(power.steps);
        lead + lead * power.rest
    } else {
        far_power(x)
    }
}

/// e^x − 1, without cancellation; measured within 0.76 ulp. ±0 gives ±0, −∞ gives −1, an overflow gives ∞, NaN gives
/// NaN.
#[function]
pub fn exp_m1(x: f64) -> f64 {
    let size = x.abs();
    if size < 0.3 {
        // 2⁻⁵⁴
        if size < 5.551115123125783e-17 {
            return x;
        }
        let z = x * x;
        let even = EXP_M1[4] + z * (EXP_M1[6] + z * (EXP_M1[8] + z * EXP_M1[10]));
        let odd = EXP_M1[3] + z * (EXP_M1[5] + z * (EXP_M1[7] + z * EXP_M1[9]));
        let tail = EXP_M1[0] + x * (EXP_M1[1] + x * (EXP_M1[2] + x * (odd + x * even)));
        x + (0.5 * z + x * z * tail)
    } else if size < NORMAL {
        let power = power(x);
        let lead = step(power.steps);
        let less = sum(lead, -1.0);
        less.high + (less.low + lead * power.rest)
    } else if x < 0.0 {
        -1.0
    } else {
        far(x, 0.0, 0)
    }
}
