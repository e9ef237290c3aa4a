//! The cube root, and the length of a vector of two coordinates.

use super::super::RawBits as _;
use super::super::tables::NARROW_CUBE_ROOT;
use crate::prelude::*;

/// Constant that balances the error of the first guess of the cube root, which is a third of the number's bits.
#[crate::data]
const COARSE: u32 = 0x2a51_3000;

/// The cube root of a normal number from 2⁻¹²⁵ on; `less` is subtracted from the exponent of the result.
///
/// The first guess g is a third of the number's bits, with the exponent and the significand taken as one number, cut
/// to eight bits so that its cube is exact. With w = (x − g³)/(x + 2g³), Halley's step is g + g·w, and a polynomial
/// gives the rest.
#[inline]
#[function]
fn plain_root(x: f32, less: u32) -> f32 {
    let raw = x.raw_bits();
    // A third of the upper half, in the upper half.
    let third = ((raw >> 16) & 0x7fff).wrapping_mul(0x5556);
    let bits = (third.wrapping_add(COARSE) & 0xffff_0000) | (raw & 0x8000_0000);
    let guess = f32::from_bits(bits);
    let cube = guess * guess * guess;
    let w = (x - cube) / (x + (cube + cube));
    let lead = f32::from_bits(bits.wrapping_sub(less << 23));
    let step = lead * w;
    lead + (step + step * (w * w * (NARROW_CUBE_ROOT[0] + w * NARROW_CUBE_ROOT[1])))
}

/// The cube root of numbers near or below the smallest normal number, near the largest, zero, infinities and NaN.
#[function]
pub fn far_root(x: f32) -> f32 {
    let size = x.abs();
    // By 2^±24 and back, a third of which is 8.
    if size > 0.0 && size < 1.0 {
        plain_root(x * 16_777_216.0, 8)
    } else if size > 1.0 && size <= f32::MAX {
        plain_root(x * 5.9604645e-8, 0xffff_fff8)
    } else {
        x
    }
}

/// The cube root; within 1 ulp. ±0 and ±∞ give themselves, NaN gives NaN.
#[function]
pub fn cbrtf(x: f32) -> f32 {
    // From 2⁻¹²⁵, and below 2¹²⁶.
    let plain = ((x.raw_bits() >> 16) & 0x7fff).wrapping_sub(0x100) < 0x7d80;
    if plain { plain_root(x, 0) } else { far_root(x) }
}

/// A number without the lower half of its bits: the twelve that remain have an exact square.
#[inline]
#[function]
fn upper(x: f32) -> f32 {
    f32::from_bits(x.raw_bits() & 0xffff_f000)
}

/// x² + y², with an error of little more than one rounding. The squares of the upper halves are exact (T. J. Dekker,
/// *A floating-point technique for extending the available precision*, 1971), and so is the rounding error of their
/// sum (D. E. Knuth's two-sum).
#[inline]
#[function]
fn squares(x: f32, y: f32) -> f32 {
    let wide = upper(x);
    let high = upper(y);
    let width = wide * wide;
    let height = high * high;
    let rest = (x - wide) * (x + wide) + (y - high) * (y + high);
    let sum = width + height;
    let added = sum - width;
    let lost = (width - (sum - added)) + (height - added);
    sum + (lost + rest)
}

/// √(x² + y²) where a square could overflow or underflow, and for infinities and NaN.
#[function]
pub fn far_length(x: f32, y: f32) -> f32 {
    let width = x.abs();
    let height = y.abs();
    if width > f32::MAX || height > f32::MAX {
        return f32::INFINITY;
    }
    if width.is_nan() || height.is_nan() {
        return f32::NAN;
    }
    let large = if width > height { width } else { height };
    let small = if width > height { height } else { width };
    // By 2⁻¹³ the smaller is lost.
    if small <= large * 1.2207031e-4 {
        return large;
    }
    // By 2^±90.
    if large > 1.0 {
        squares(large * 8.077936e-28, small * 8.077936e-28).sqrt() * 1.2379401e27
    } else {
        squares(large * 1.2379401e27, small * 1.2379401e27).sqrt() * 8.077936e-28
    }
}

/// √(x² + y²), without intermediate overflow; within 1 ulp. An infinite `x` or `y` gives ∞, otherwise a NaN gives
/// NaN.
#[function]
pub fn hypotf(x: f32, y: f32) -> f32 {
    let sum = squares(x, y);
    // A square below 2⁻¹²⁶ is nothing beside 10⁻²⁸. What is no number is in no range.
    if sum > 1e-28 && sum < 1e30 { sum.sqrt() } else { far_length(x, y) }
}
