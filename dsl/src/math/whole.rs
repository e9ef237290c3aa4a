//! Methods of integers that are functions of the DSL in the C, written once for all types.
//!
//! Each returns the result of core's method, and faults where that panics.

use crate::library;
use crate::prelude::*;

#[library(WholeCompanions)]
impl<T: Integer> T {
    /// `a / b`, rounded up.
    pub fn div_ceil(a: Self, b: Self) -> Self {
        let quotient = a / b;
        if a % b == T::ZERO { quotient } else { quotient + T::ONE }
    }

    /// The smallest multiple of `b` that is not below `a`.
    pub fn next_multiple_of(a: Self, b: Self) -> Self {
        let rest = a % b;
        if rest == T::ZERO { a } else { a + (b - rest) }
    }

    /// Returns true if `a` is a multiple of `b`; for `b` = 0, if `a` is 0.
    pub fn is_multiple_of(a: Self, b: Self) -> bool {
        if b == T::ZERO { a == T::ZERO } else { a % b == T::ZERO }
    }

    /// The smallest power of two that is not below `a`.
    pub fn next_power_of_two(a: Self) -> Self {
        filled(a) + T::ONE
    }

    /// The smallest power of two that is not below `a`; `None` if the type cannot represent it.
    pub fn checked_next_power_of_two(a: Self) -> Option<Self> {
        let below = filled(a);
        if below == T::MAX { None } else { Some(below.wrapping_add(T::ONE)) }
    }

    /// The position of the highest bit.
    pub fn ilog2(a: Self) -> u32 {
        assert!(a > T::ZERO);
        T::BITS - 1 - a.leading_zeros()
    }

    /// The logarithm to base 2, rounded down; `None` for 0 and negative numbers.
    pub fn checked_ilog2(a: Self) -> Option<u32> {
        if a > T::ZERO { Some(T::BITS - 1 - a.leading_zeros()) } else { None }
    }

    /// The square root, rounded down: one bit after another, from the highest.
    pub fn isqrt(a: Self) -> Self {
        assert!(a >= T::ZERO);
        let mut rest = a;
        let mut root = T::ZERO;
        for step in 1..=T::BITS / 2 {
            let bit = T::ONE.wrapping_shl(T::BITS - 2 * step);
            let tried = root.wrapping_add(bit);
            root = root.wrapping_shr(1);
            if rest >= tried {
                rest = rest.wrapping_sub(tried);
                root = root.wrapping_add(bit);
            }
        }
        root
    }

    /// Half of `a + b`, rounded towards zero; the sum itself may overflow the type.
    pub fn midpoint(a: Self, b: Self) -> Self {
        let differing = a ^ b;
        let middle = (a & b).wrapping_add(differing >> 1);
        if middle < T::ZERO { middle.wrapping_add(differing & T::ONE) } else { middle }
    }

    /// The bits in reverse order: first the bytes, then the halves, quarters and eighths of each byte.
    pub fn reverse_bits(a: Self) -> Self {
        let bytes = a.swap_bytes();
        let halves = exchanged(bytes, T::NIBBLES, 4);
        exchanged(exchanged(halves, T::PAIRS, 2), T::ODDS, 1)
    }

    /// `a + b` wrapped to the type's width, and whether the sum overflowed.
    pub fn overflowing_add(a: Self, b: Self) -> (Self, bool) {
        let sum = a.wrapping_add(b);
        (sum, (b < T::ZERO) != (sum < a))
    }

    /// `a - b` wrapped to the type's width, and whether the difference overflowed.
    pub fn overflowing_sub(a: Self, b: Self) -> (Self, bool) {
        let difference = a.wrapping_sub(b);
        (difference, (b > T::ZERO) != (difference < a))
    }

    /// `a * b` wrapped to the type's width, and whether the product overflowed.
    pub fn overflowing_mul(a: Self, b: Self) -> (Self, bool) {
        let product = a.wrapping_mul(b);
        if a == T::ZERO {
            return (product, false);
        }
        // The least number of a signed type is its own negative, and so hides that the product is another.
        let hidden = b < T::ZERO && b == T::MIN && a == T::ZERO.wrapping_sub(T::ONE);
        (product, hidden || product.wrapping_div(a) != b)
    }

    /// `a * b + carry` in twice the width: the low and the high half.
    pub fn carrying_mul(a: Self, b: Self, carry: Self) -> (Self, Self) {
        let half = T::BITS / 2;
        let mask = T::MAX.wrapping_shr(half);
        let (lower, upper) = (a & mask, a.wrapping_shr(half));
        let (below, above) = (b & mask, b.wrapping_shr(half));
        let least = lower.wrapping_mul(below);
        let first = upper.wrapping_mul(below).wrapping_add(least.wrapping_shr(half));
        let second = lower.wrapping_mul(above).wrapping_add(first & mask);
        let high = upper.wrapping_mul(above).wrapping_add(first.wrapping_shr(half));
        let high = high.wrapping_add(second.wrapping_shr(half));
        let low = second.wrapping_shl(half) | (least & mask);
        let sum = low.wrapping_add(carry);
        (sum, if sum < low { high.wrapping_add(T::ONE) } else { high })
    }

    /// `-a` wrapped to the type's width, and whether the result overflowed.
    pub fn overflowing_neg(a: Self) -> (Self, bool) {
        let negative = T::ZERO.wrapping_sub(a);
        (negative, a != T::ZERO && (a < T::ZERO) == (negative < T::ZERO))
    }

    /// Moves the bits up, modulo the width; true if `bits` are as many or more.
    pub fn overflowing_shl(a: Self, bits: u32) -> (Self, bool) {
        (a.wrapping_shl(bits), bits >= T::BITS)
    }

    /// Moves the bits down, modulo the width; true if `bits` are as many or more.
    pub fn overflowing_shr(a: Self, bits: u32) -> (Self, bool) {
        (a.wrapping_shr(bits), bits >= T::BITS)
    }

    /// `a / b`, or the largest value if the quotient overflows.
    pub fn saturating_div(a: Self, b: Self) -> Self {
        if a < T::ZERO && a == T::MIN && b == T::ZERO.wrapping_sub(T::ONE) { T::MAX } else { a / b }
    }

    /// `base` to the power of `exponent`, or the nearest value of the type.
    pub fn saturating_pow(base: Self, exponent: u32) -> Self {
        let nearest = if base < T::ZERO && exponent & 1 == 1 { T::MIN } else { T::MAX };
        let mut result = T::ONE;
        let mut square = (base, false);
        let mut left = exponent;
        for _ in 0..32 {
            if left & 1 == 1 {
                let (product, is_other) = overflowing_mul(result, square.0);
                if square.1 || is_other {
                    return nearest;
                }
                result = product;
            }
            left >>= 1;
            if left == 0 {
                break;
            }
            let (next, is_other) = overflowing_mul(square.0, square.0);
            square = (next, square.1 || is_other);
        }
        result
    }

    /// The quotient with a remainder of 0 or more; `None` for a divisor of 0 or an overflow.
    pub fn checked_div_euclid(a: Self, b: Self) -> Option<Self> {
        if b == T::ZERO || a < T::ZERO && a == T::MIN && b == T::ZERO.wrapping_sub(T::ONE) {
            return None;
        }
        let quotient = a / b;
        if a % b >= T::ZERO {
            return Some(quotient);
        }
        Some(if b > T::ZERO {
            quotient.wrapping_sub(T::ONE)
        } else {
            quotient.wrapping_add(T::ONE)
        })
    }

    /// The remainder of 0 or more; `None` for a divisor of 0 or an overflow of the quotient.
    pub fn checked_rem_euclid(a: Self, b: Self) -> Option<Self> {
        if b == T::ZERO || a < T::ZERO && a == T::MIN && b == T::ZERO.wrapping_sub(T::ONE) {
            return None;
        }
        let rest = a % b;
        let step = if b < T::ZERO { T::ZERO.wrapping_sub(b) } else { b };
        Some(if rest < T::ZERO { rest.wrapping_add(step) } else { rest })
    }

    /// The smallest multiple of `b` that is not below `a`; `None` for a `b` of 0 or an overflow.
    pub fn checked_next_multiple_of(a: Self, b: Self) -> Option<Self> {
        if b == T::ZERO {
            return None;
        }
        let rest = a % b;
        let next = if rest == T::ZERO { a } else { a.wrapping_add(b.wrapping_sub(rest)) };
        if next < a { None } else { Some(next) }
    }

    /// The square root, rounded down; `None` for a negative number.
    pub fn checked_isqrt(a: Self) -> Option<Self> {
        if a < T::ZERO { None } else { Some(isqrt(a)) }
    }

    /// The logarithm to base 10, rounded down.
    pub fn ilog10(a: Self) -> u32 {
        assert!(a > T::ZERO);
        let ten = (T::ONE << 3) | (T::ONE << 1);
        let (mut rest, mut digits) = (a, 0);
        for _ in 0..19 {
            rest = rest / ten;
            digits += u32::from(rest > T::ZERO);
        }
        digits
    }

    /// The logarithm to base 10, rounded down; `None` for 0 and negative numbers.
    pub fn checked_ilog10(a: Self) -> Option<u32> {
        if a > T::ZERO { Some(ilog10(a)) } else { None }
    }

    /// `a << bits`; 0 if `bits` is not below the width.
    pub fn unbounded_shl(a: Self, bits: u32) -> Self {
        if bits < T::BITS { a << bits } else { T::ZERO }
    }

    /// `a >> bits`; if `bits` is not below the width, 0 or, for a negative number, −1.
    pub fn unbounded_shr(a: Self, bits: u32) -> Self {
        if bits < T::BITS {
            a >> bits
        } else if a < T::ZERO {
            T::ZERO.wrapping_sub(T::ONE)
        } else {
            T::ZERO
        }
    }
}

/// `a - 1` with all bits below its highest 1 set.
#[function]
pub fn filled<T: Integer>(a: T) -> T {
    if a <= T::ONE {
        T::ZERO
    } else {
        T::MAX.wrapping_shr((a.wrapping_sub(T::ONE)).leading_zeros())
    }
}

/// Exchanges neighbouring groups of `by` bits; `low` is the mask of the lower group of each pair.
#[function]
pub fn exchanged<T: Integer>(a: T, low: T, by: u32) -> T {
    ((a & low).wrapping_shl(by)) | (a.wrapping_shr(by) & low)
}
