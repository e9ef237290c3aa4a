//! The cube root and the length of two coordinates.

use super::super::RawBits as _;
use super::super::tables::NARROW_CUBE_ROOT;
use crate::prelude::*;

/// What makes a third of the bits right in the middle.
#[crate::data]
const COARSE: u32 = 0x2a51_3000;

/// The cube root of a normal number of 2⁻¹²⁵ or more; the exponent of the result is `less` below that. The first guess g is a third
/// of the exponent, and of the significand as if it went on from it, cut to eight bits so that its cube is exact. With
/// w = (x − g³)/(x + 2g³), Halley's step is g + g·w; what that leaves out is a polynomial's.
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

/// The cube root of what is next to the subnormal numbers or below, next to the largest, zero or no number.
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

/// √(x² + y²) for 2⁻⁵⁰ to 2⁵⁰, the larger first: the root of the sum, and what it is off by, from differences that lose
/// nothing (C. F. Borges, *An improved algorithm for hypot(a, b)*, 2019).
#[inline]
#[function]
fn length(large: f32, small: f32) -> f32 {
    let guess = (large * large + small * small).sqrt();
    let off = if guess <= 2.0 * small {
        let delta = guess - small;
        large * (2.0 * delta - large) + (delta - 2.0 * (large - small)) * delta
    } else {
        let delta = guess - large;
        2.0 * delta * (large - 2.0 * small) + ((4.0 * delta - small) * small + delta * delta)
    };
    guess - off / (2.0 * guess)
}

/// √(x² + y²) where a square could leave the range; the larger first, and neither negative.
#[function]
pub fn far_length(large: f32, small: f32) -> f32 {
    if large > f32::MAX || small > f32::MAX {
        return f32::INFINITY;
    }
    if large.is_nan() || small.is_nan() {
        return f32::NAN;
    }
    // By 2⁻¹³ the smaller is lost.
    if small <= large * 1.2207031e-4 {
        return large;
    }
    // By 2^±90.
    if large > 1e15 {
        length(large * 8.077936e-28, small * 8.077936e-28) * 1.2379401e27
    } else {
        length(large * 1.2379401e27, small * 1.2379401e27) * 8.077936e-28
    }
}

/// √(x² + y²), without overflow on the way; within 1 ulp. An infinite `x` or `y` gives ∞, else a
/// NaN gives NaN.
#[function]
pub fn hypotf(x: f32, y: f32) -> f32 {
    let width = x.abs();
    let height = y.abs();
    let large = if width > height { width } else { height };
    let small = if width > height { height } else { width };
    if large < 1e15 && small > 1e-14 { length(large, small) } else { far_length(large, small) }
}
