//! Reduction of angles to at most a quarter turn, in two doubles.
//!
//! Moderate angles are reduced after Cody and Waite, *Software Manual for the Elementary Functions* (1980), with π/2
//! in four parts. Huge angles are reduced after M. Payne and R. Hanek, *Radian reduction for trigonometric functions*
//! (SIGNUM Newsletter 18, 1983), with 192 bits of 2/π from the first that does not only add whole turns. The angle's
//! 53 bits and two bits of the quadrant leave 137 fractional bits; no double is nearer than 2⁻⁶² to a multiple of π/2
//! (J.-M. Muller, *Elementary Functions*, chapter 11). The work is the same for every angle.

use core::f64::consts::FRAC_2_PI;

use super::RawBits as _;
use super::pair::{Pair, ordered_sum, sum, times};
use super::sine::TO_INTEGER;
use super::tables::{
    HALF_PI_HIGH, HALF_PI_LOW, QUARTER_TURN_1, QUARTER_TURN_2, QUARTER_TURN_3, QUARTER_TURN_4,
    TWO_OVER_PI,
};
use crate::prelude::*;

/// An angle as a number of quarter turns and a remainder.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReducedAngle {
    /// The remainder, rad, −π/4 to π/4.
    pub high: f64,
    /// The error of `high`.
    pub low: f64,
    /// Number of quarter turns modulo four: 0, 1, 2 or 3.
    pub quadrant: u64,
}

/// Up to this angle, in rad, the number of quarter turns is below 2²⁰.
#[crate::data]
const FEW_TURNS: f64 = 1_600_000.0;

/// Subtracts whole quarter turns from `x`, rad.
#[function]
pub fn reduce(x: f64) -> ReducedAngle {
    let size = x.abs();
    if size < 0.75 {
        ReducedAngle { high: x, low: 0.0, quadrant: 0 }
    } else if size <= FEW_TURNS {
        let shifted = x * FRAC_2_PI + TO_INTEGER;
        let quarter_turns = shifted - TO_INTEGER;
        // Three products without loss; what the two differences lose is kept.
        let first = x - quarter_turns * QUARTER_TURN_1;
        let part = quarter_turns * QUARTER_TURN_2;
        let second = first - part;
        let taken = first - second;
        let lost = (first - (second + taken)) + (taken - part);
        let part = quarter_turns * QUARTER_TURN_3;
        let third = second - part;
        let taken = second - third;
        let lost = lost + ((second - (third + taken)) + (taken - part));
        let rest = lost - quarter_turns * QUARTER_TURN_4;
        let high = third + rest;
        ReducedAngle { high, low: rest - (high - third), quadrant: shifted.raw_bits() & 3 }
    } else if size <= f64::MAX {
        reduce_huge(x)
    } else {
        ReducedAngle { high: f64::NAN, low: 0.0, quadrant: 0 }
    }
}

/// The upper 64 bits of a product.
#[inline]
#[function]
pub(crate) fn upper_product(a: u64, b: u64) -> u64 {
    let a_high = a >> 32;
    let a_low = a & 0xffff_ffff;
    let b_high = b >> 32;
    let b_low = b & 0xffff_ffff;
    let first = a_high.wrapping_mul(b_low).wrapping_add(a_low.wrapping_mul(b_low) >> 32);
    let second = a_low.wrapping_mul(b_high).wrapping_add(first & 0xffff_ffff);
    a_high.wrapping_mul(b_high).wrapping_add(first >> 32).wrapping_add(second >> 32)
}

/// 64 bits of 2/π, from bit `shift` of `word` on; `next` is the word after it.
#[inline]
#[function]
fn window(word: u64, next: u64, shift: u64) -> u64 {
    let shift = shift & 63;
    (word << shift) | ((next >> 1) >> (63 - shift))
}

/// Subtracts whole quarter turns from an angle of 2²⁰ rad or more.
#[function]
pub fn reduce_huge(x: f64) -> ReducedAngle {
    let bits = x.raw_bits();
    // Bits of 2/π before this one make whole turns. The table starts with 64 zeros.
    let start = ((bits >> 52) & 0x7ff).wrapping_sub(1023 + 52 + 2 - 64);
    let mantissa = (bits & 0x000f_ffff_ffff_ffff) | 0x0010_0000_0000_0000;
    let word = ((start >> 6) & 31) as usize;
    let third = TWO_OVER_PI[word + 2];
    let high = window(TWO_OVER_PI[word], TWO_OVER_PI[word + 1], start);
    let middle = window(TWO_OVER_PI[word + 1], third, start);
    let low = window(third, TWO_OVER_PI[word + 3], start);

    // The product modulo four turns, in 192 bits of which two are before the point.
    let last = mantissa.wrapping_mul(low);
    let carried = upper_product(mantissa, low);
    let centre = mantissa.wrapping_mul(middle).wrapping_add(carried);
    let carry = if centre < carried { 1 } else { 0 };
    let first = mantissa
        .wrapping_mul(high)
        .wrapping_add(upper_product(mantissa, middle))
        .wrapping_add(carry);

    // To the nearest quarter turn; the fraction is signed.
    let quarter_turns = first.wrapping_add(0x2000_0000_0000_0000) >> 62;
    let fraction = (first << 2) | (centre >> 62);
    let negative = (fraction >> 63) == 1;
    let flip = if negative { 0xffff_ffff_ffff_ffff } else { 0 };
    let head = fraction ^ flip;
    let tail = ((centre << 2) | (last >> 62)) ^ flip;
    let end = (last << 2) ^ flip;

    let lead = sum(
        ((head >> 32) as u32) as f64 * 2.3283064365386963e-10,
        ((head & 0xffff_ffff) as u32) as f64 * 5.421010862427522e-20,
    );
    let rest = sum(lead.low, ((tail >> 32) as u32) as f64 * 1.262177448353619e-29);
    let least = ((tail & 0xffff_ffff) as u32) as f64 * 2.938735877055719e-39
        + ((end >> 32) as u32) as f64 * 6.842277657836021e-49;
    let upper = ordered_sum(lead.high, rest.high);
    let fraction = ordered_sum(upper.high, upper.low + (rest.low + least));
    let angle = times(fraction, Pair { high: HALF_PI_HIGH, low: HALF_PI_LOW });

    let backwards = x < 0.0;
    let sign = if negative != backwards { -1.0 } else { 1.0 };
    ReducedAngle {
        high: sign * angle.high,
        low: sign * angle.low,
        quadrant: if backwards { 4u64.wrapping_sub(quarter_turns) & 3 } else { quarter_turns & 3 },
    }
}
