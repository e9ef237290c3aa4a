//! The cube root, and the length of a vector of two coordinates.

use super::RawBits as _;
use super::tables::CUBE_ROOT;
use crate::prelude::*;

/// A number within 4 % of the cube root, computed from the number's upper bits.
///
/// The exponent and the significand are taken as one number and divided by three. `bias` is two thirds of the
/// exponent's bias, in the same place, and balances the error.
#[inline]
#[function]
pub(crate) fn coarse_root(upper: u32, bias: u32) -> f64 {
    f64::from_bits(((upper / 3).wrapping_add(bias) as u64) << 32)
}

/// The cube root; measured within 0.83 ulp. ±0 and ±∞ give themselves, NaN gives NaN.
///
/// [`coarse_root`] is improved by a polynomial in the ratio of its cube to `x`, cut to 26 bits so that its square is
/// exact, and then improved by one step of Halley's method.
#[function]
pub fn cbrt(x: f64) -> f64 {
    let size = x.abs();
    if !(size > 0.0 && size <= f64::MAX) {
        return x;
    }
    let coarse = if size < f64::MIN_POSITIVE {
        // By 2⁵⁴ and back, a third of which is 18.
        coarse_root(
            ((size * 18_014_398_509_481_984.0).raw_bits() >> 32) as u32,
            COARSE - (18 << 20),
        )
    } else {
        coarse_root((size.raw_bits() >> 32) as u32, COARSE)
    };
    let ratio = (coarse * coarse) * (coarse / size);
    let upper = CUBE_ROOT[3] + ratio * CUBE_ROOT[4];
    let factor = CUBE_ROOT[0] + ratio * (CUBE_ROOT[1] + ratio * (CUBE_ROOT[2] + ratio * upper));
    let guess = f64::from_bits(
        (coarse * factor).raw_bits().wrapping_add(0x4000_0000) & 0xffff_ffff_8000_0000,
    );
    let quotient = size / (guess * guess);
    let value = guess + guess * ((quotient - guess) / ((guess + guess) + quotient));
    if x < 0.0 { -value } else { value }
}

/// Constant that centres the error of [`coarse_root`].
#[crate::data]
pub(crate) const COARSE: u32 = 0x2a9f_7100;

/// √(x² + y²) for `large` and `small` from 2^−500 to 2^500. The root of the sum is corrected by exact differences (C.
/// F. Borges, *An improved algorithm for hypot(a, b)*, 2019).
#[inline]
#[function]
fn length(large: f64, small: f64) -> f64 {
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

/// √(x² + y²) where a square could overflow or underflow; neither number is negative.
#[function]
pub fn far_length(large: f64, small: f64) -> f64 {
    if large > f64::MAX || small > f64::MAX {
        return f64::INFINITY;
    }
    // False for NaN.
    if !(large <= f64::MAX && small <= f64::MAX) {
        return f64::NAN;
    }
    // By 2⁻⁶⁰ the smaller is lost.
    if small <= large * 8.673617379884035e-19 {
        return large + small;
    }
    // By 2^±600.
    if large > 1e150 {
        length(large * 2.409919865102884e-181, small * 2.409919865102884e-181)
            * 4.149515568880993e180
    } else {
        length(large * 4.149515568880993e180, small * 4.149515568880993e180)
            * 2.409919865102884e-181
    }
}

/// √(x² + y²), without intermediate overflow; measured within 0.66 ulp. An infinite `x` or `y` gives ∞, otherwise a
/// NaN gives NaN.
#[function]
pub fn hypot(x: f64, y: f64) -> f64 {
    let width = x.abs();
    let height = y.abs();
    let large = if width > height { width } else { height };
    let small = if width > height { height } else { width };
    if large < 1e150 && small > 1e-130 { length(large, small) } else { far_length(large, small) }
}

/// The square root; `None` for a negative number. As in nalgebra, ±0 gives ±0.
#[function(expand)]
pub fn try_sqrt<T: Real>(x: T) -> Option<T> {
    if x >= T::ZERO { Some(x.sqrt()) } else { None }
}
