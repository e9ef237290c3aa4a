//! Numbers as the unevaluated sum of two doubles.
//!
//! After T. J. Dekker, *A floating-point technique for extending the available precision* (Numer.
//! Math. 18, 1971), and D. E. Knuth, *The Art of Computer Programming*, volume 2. None of these needs
//! a fused multiply-add, so all targets agree.

use crate::prelude::*;

/// Mask of the upper half of a double's bits: the product of two doubles masked by it is exact.
#[crate::data]
pub(crate) const UPPER: u64 = 0xffff_ffff_0000_0000;
/// Mask of all bits of a double except the last 27: the square of a double masked by it is exact.
#[crate::data]
pub(crate) const LEADING: u64 = 0xffff_ffff_f800_0000;
/// 2²⁷ + 1: a product with it splits a double into halves of 26 bits (Veltkamp).
#[crate::data]
pub(crate) const SPLITTER: f64 = 134_217_729.0;

/// A number as the sum of a double and a correction.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// The leading part.
    pub high: f64,
    /// The lower part.
    pub low: f64,
}

/// The exact sum `a + b` (Knuth).
#[inline]
#[function]
pub(crate) fn sum(a: f64, b: f64) -> Pair {
    let high = a + b;
    let from_b = high - a;
    Pair { high, low: (a - (high - from_b)) + (b - from_b) }
}

/// The exact sum `a + b`, if `a` is zero or not the smaller in magnitude (Dekker).
#[inline]
#[function]
pub(crate) fn ordered_sum(a: f64, b: f64) -> Pair {
    let high = a + b;
    Pair { high, low: b - (high - a) }
}

/// The exact product `a * b`, below 2⁹⁹⁶ and without underflow (Dekker, Veltkamp).
#[inline]
#[function]
pub(crate) fn product(a: f64, b: f64) -> Pair {
    let a_scaled = SPLITTER * a;
    let a_high = a_scaled - (a_scaled - a);
    let a_low = a - a_high;
    let b_scaled = SPLITTER * b;
    let b_high = b_scaled - (b_scaled - b);
    let b_low = b - b_high;
    let high = a * b;
    let low = ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low;
    Pair { high, low }
}

/// `a * b` to about 100 bits.
#[inline]
#[function]
pub(crate) fn times(a: Pair, b: Pair) -> Pair {
    let lead = product(a.high, b.high);
    ordered_sum(lead.high, lead.low + (a.high * b.low + a.low * b.high))
}

/// `a / b` to about 100 bits.
#[inline]
#[function]
pub(crate) fn quotient(a: Pair, b: Pair) -> Pair {
    let above = ordered_sum(a.high, a.low);
    let below = ordered_sum(b.high, b.low);
    let high = above.high / below.high;
    let back = product(high, below.high);
    let rest = ((above.high - back.high) - back.low + above.low) - high * below.low;
    ordered_sum(high, rest / below.high)
}
