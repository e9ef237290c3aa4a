//! Reduction of angles to at most a quarter turn, as a sum of two floats.
//!
//! Moderate angles are reduced after Cody and Waite, *Software Manual for the Elementary Functions* (1980), with π/2
//! in three parts. Huge angles are reduced after M. Payne and R. Hanek, *Radian reduction for trigonometric
//! functions* (SIGNUM Newsletter 18, 1983), with 96 bits of 2/π from the first that does not only add whole turns.
//! The angle's 24 bits and two bits of the quadrant leave 70 fractional bits; no float is nearer than 2⁻³⁰ to a
//! multiple of π/2.

use core::f32::consts::FRAC_2_PI;

use super::super::RawBits as _;
use super::super::tables::{
    NARROW_QUARTER_1, NARROW_QUARTER_2, NARROW_QUARTER_3, NARROW_TURN_1, NARROW_TURN_2,
    NARROW_TURN_3, TWO_OVER_PI_WORDS,
};
use super::{PairF32, TO_INTEGER, leading, ordered_sum};
use crate::prelude::*;

/// An angle as a number of quarter turns and a remainder.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReducedF32 {
    /// The remainder, rad, −π/4 to π/4.
    pub high: f32,
    /// The error of `high`.
    pub low: f32,
    /// Number of quarter turns; only the last two bits count.
    pub quadrant: u32,
}

/// Up to this angle, in rad, the number of quarter turns is below 2⁸.
#[crate::data]
pub(crate) const FEW_TURNS: f32 = 400.0;

/// Subtracts whole quarter turns from `x`, rad, for |x| up to [`FEW_TURNS`].
#[inline]
#[function]
fn reduced_moderate(x: f32) -> ReducedF32 {
    let shifted = x * FRAC_2_PI + TO_INTEGER;
    let quarter_turns = shifted - TO_INTEGER;
    // Two products without loss, and a first difference; what the second loses is kept.
    let first = x - quarter_turns * NARROW_TURN_1;
    let part = quarter_turns * NARROW_TURN_2;
    let lead = first - part;
    let lost = ((first - lead) - part) - quarter_turns * NARROW_TURN_3;
    let high = lead + lost;
    ReducedF32 { high, low: (lead - high) + lost, quadrant: shifted.raw_bits() }
}

/// Subtracts multiples of π/2 from `x`, rad, for |x| of 2⁸ or more, infinities and NaN.
#[function]
pub fn reduced_far(x: f32) -> ReducedF32 {
    if x.abs() <= f32::MAX {
        reduced_huge(x)
    } else {
        ReducedF32 { high: f32::NAN, low: 0.0, quadrant: 0 }
    }
}

/// Subtracts whole quarter turns from `x`, rad; −0 becomes 0.
#[inline]
#[function]
pub(crate) fn reduced_angle(x: f32) -> ReducedF32 {
    if x.abs() <= FEW_TURNS { reduced_moderate(x) } else { reduced_far(x) }
}

/// Subtracts multiples of π/2 from `x`, rad, for |x| below 2⁸; −0 stays −0. `low` may be larger than `high` where both
/// are nearly 0.
///
/// `low` is a negated sum, so that it is −0 for an angle of ±0.
#[inline]
#[function]
pub(crate) fn reduced_near(x: f32) -> ReducedF32 {
    let shifted = x * FRAC_2_PI + TO_INTEGER;
    let quadrants = shifted - TO_INTEGER;
    // Two products and a first difference without loss; what the second difference loses is kept.
    let first = x - quadrants * NARROW_TURN_1;
    let part = quadrants * NARROW_TURN_2;
    let high = first - part;
    let excess = ((high - first) + part) + quadrants * NARROW_TURN_3;
    ReducedF32 { high, low: -excess, quadrant: shifted.raw_bits() }
}

/// The upper 32 bits of a product.
#[inline]
#[function]
pub(crate) fn upper_product(a: u32, b: u32) -> u32 {
    let a_high = a >> 16;
    let a_low = a & 0xffff;
    let b_high = b >> 16;
    let b_low = b & 0xffff;
    let first = a_high.wrapping_mul(b_low).wrapping_add(a_low.wrapping_mul(b_low) >> 16);
    let second = a_low.wrapping_mul(b_high).wrapping_add(first & 0xffff);
    a_high.wrapping_mul(b_high).wrapping_add(first >> 16).wrapping_add(second >> 16)
}

/// 32 bits of 2/π, from bit `shift` of `word` on; `next` is the word after it.
#[inline]
#[function]
fn window(word: u32, next: u32, shift: u32) -> u32 {
    let shift = shift & 31;
    (word << shift) | ((next >> 1) >> (31 - shift))
}

/// A fraction of a quarter turn, with 64 fractional bits, converted to rad.
#[inline]
#[function]
fn radians(head: u32, tail: u32) -> PairF32 {
    // Three parts of 24, 24 and 16 bits.
    let lead = (head >> 8) as f32 * 5.9604645e-8;
    let next = (((head & 0xff) << 16) | (tail >> 16)) as f32 * 3.5527137e-15;
    let rest = ordered_sum(lead, next);
    let last = (tail & 0xffff) as f32 * 5.421011e-20;
    let quarter_turns = ordered_sum(rest.high, rest.low + last);
    let upper = leading(quarter_turns.high);
    let lower = quarter_turns.high - upper;
    let small = upper * NARROW_QUARTER_2 + lower * NARROW_QUARTER_1;
    let least = (upper * NARROW_QUARTER_3 + lower * NARROW_QUARTER_2)
        + quarter_turns.low * (NARROW_QUARTER_1 + NARROW_QUARTER_2);
    ordered_sum(upper * NARROW_QUARTER_1, small + least)
}

/// Subtracts whole quarter turns from an angle of 2⁸ rad or more.
#[function]
pub fn reduced_huge(x: f32) -> ReducedF32 {
    let bits = x.raw_bits();
    // Bits of 2/π before this one make whole turns. The table starts with 32 zeros.
    let start = ((bits >> 23) & 0xff).wrapping_sub(127 + 23 + 2 - 32);
    let mantissa = (bits & 0x007f_ffff) | 0x0080_0000;
    let word = ((start >> 5) & 7) as usize;
    let third = TWO_OVER_PI_WORDS[word + 2];
    let high = window(TWO_OVER_PI_WORDS[word], TWO_OVER_PI_WORDS[word + 1], start);
    let middle = window(TWO_OVER_PI_WORDS[word + 1], third, start);
    let low = window(third, TWO_OVER_PI_WORDS[word + 3], start);

    // The product modulo four turns, in 96 bits of which two are before the point.
    let last = mantissa.wrapping_mul(low);
    let carried = upper_product(mantissa, low);
    let centre = mantissa.wrapping_mul(middle).wrapping_add(carried);
    let carry = if centre < carried { 1 } else { 0 };
    let first = mantissa
        .wrapping_mul(high)
        .wrapping_add(upper_product(mantissa, middle))
        .wrapping_add(carry);

    // To the nearest quarter turn; the fraction is signed.
    let quarter_turns = first.wrapping_add(0x2000_0000) >> 30;
    let fraction = (first << 2) | (centre >> 30);
    let negative = (fraction >> 31) == 1;
    let flip = if negative { 0xffff_ffff } else { 0 };
    let angle = radians(fraction ^ flip, ((centre << 2) | (last >> 30)) ^ flip);

    let backwards = x < 0.0;
    let sign = if negative != backwards { -1.0 } else { 1.0 };
    ReducedF32 {
        high: sign * angle.high,
        low: sign * angle.low,
        quadrant: if backwards { 4u32.wrapping_sub(quarter_turns) } else { quarter_turns },
    }
}
