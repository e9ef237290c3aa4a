//! Rust's `u128` in the C.

use crate::Plain;
use crate::prelude::*;

/// An unsigned integer of 128 bits.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct U128 {
    /// The upper 64 bits.
    pub high: u64,
    /// The lower 64 bits.
    pub low: u64,
}

/// The words are the upper and the lower 64 bits.
#[diagnostic::do_not_recommend]
impl Plain for ::core::primitive::u128 {
    const WORDS: usize = 2;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out((*self >> 64) as u64);
        out(*self as u64);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let high = next();
        Self::from(high) << 64 | Self::from(next())
    }
}

/// Mask of the lower half of a word.
const LOWER: u64 = 0xFFFF_FFFF;

/// The sum of two words.
#[function]
#[inline]
pub fn sum_of_words(one: u64, other: u64) -> U128 {
    let low = one.wrapping_add(other);
    U128 { high: u64::from(low < one), low }
}

/// The product of two words, from the products of their halves.
#[function]
#[inline]
pub fn product_of_words(one: u64, other: u64) -> U128 {
    let (one_upper, one_lower) = (one >> 32, one & LOWER);
    let (other_upper, other_lower) = (other >> 32, other & LOWER);
    let least = one_lower * other_lower;
    let first = one_upper * other_lower + (least >> 32);
    let second = one_lower * other_upper + (first & LOWER);
    U128 {
        high: one_upper * other_upper + (first >> 32) + (second >> 32),
        low: (second << 32) | (least & LOWER),
    }
}

/// The sum of two numbers of 32 bits.
#[function(expand)]
pub fn sum_of_halves(one: u32, other: u32) -> U128 {
    U128 { high: 0, low: u64::from(one) + u64::from(other) }
}

/// The product of two numbers of 32 bits.
#[function(expand)]
pub fn product_of_halves(one: u32, other: u32) -> U128 {
    U128 { high: 0, low: u64::from(one) * u64::from(other) }
}

/// The sum, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_add(one: U128, other: U128) -> U128 {
    let low = one.low.wrapping_add(other.low);
    let carry = u64::from(low < one.low);
    U128 { high: one.high.wrapping_add(other.high).wrapping_add(carry), low }
}

/// The difference, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_sub(one: U128, other: U128) -> U128 {
    let borrow = u64::from(one.low < other.low);
    U128 {
        high: one.high.wrapping_sub(other.high).wrapping_sub(borrow),
        low: one.low.wrapping_sub(other.low),
    }
}

/// The product, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_mul(one: U128, other: U128) -> U128 {
    let product = product_of_words(one.low, other.low);
    let crossed = one.high.wrapping_mul(other.low).wrapping_add(one.low.wrapping_mul(other.high));
    U128 { high: product.high.wrapping_add(crossed), low: product.low }
}

/// Returns true if the sum of two numbers needs more than 128 bits.
#[function]
#[inline]
pub fn sum_overflows(one: U128, other: U128) -> bool {
    wrapping_add(one, other) < one
}

/// Returns true if the product of two numbers needs more than 128 bits.
#[function]
#[inline]
pub fn product_overflows(one: U128, other: U128) -> bool {
    if one.high != 0 && other.high != 0 {
        return true;
    }
    // At most one of these is not zero.
    let first = product_of_words(one.high, other.low);
    let second = product_of_words(one.low, other.high);
    let crossed = first.low | second.low;
    let upper = product_of_words(one.low, other.low).high;
    (first.high | second.high) != 0 || crossed.wrapping_add(upper) < crossed
}

/// Moves the bits up, by `bits` modulo 128.
#[function]
#[inline]
pub fn wrapping_shl(number: U128, bits: u32) -> U128 {
    let within = bits & 63;
    let high = (number.high << within) | ((number.low >> 1) >> (63 - within));
    let low = number.low << within;
    if bits & 64 == 0 { U128 { high, low } } else { U128 { high: low, low: 0 } }
}

/// Moves the bits down, by `bits` modulo 128.
#[function]
#[inline]
pub fn wrapping_shr(number: U128, bits: u32) -> U128 {
    let within = bits & 63;
    let high = number.high >> within;
    let low = (number.low >> within) | ((number.high << 1) << (63 - within));
    if bits & 64 == 0 { U128 { high, low } } else { U128 { high: 0, low: high } }
}

/// One digit of 32 bits of the quotient of `upper`·2³² + `next` and a divisor that is greater than `upper`.
///
/// The divisor is at least 2⁶³.
#[function]
#[inline]
pub fn quotient_digit(upper: u64, next: u64, divisor: u64) -> u64 {
    // The divisor's upper half is at least 2³¹, and so no divisor of 0.
    let (leading, lower) = ((divisor >> 32).max(0x8000_0000), divisor & LOWER);
    // The estimate by the upper half of the divisor is too large by at most 2.
    let mut digit = (upper / leading).min(LOWER);
    let mut rest = upper.wrapping_sub(digit.wrapping_mul(leading));
    for _ in 0..2 {
        if rest <= LOWER && digit.wrapping_mul(lower) > ((rest << 32) | next) {
            digit = digit.wrapping_sub(1);
            rest = rest.wrapping_add(leading);
        }
    }
    digit
}

/// The quotient of a number and a word that is greater than the number's upper word.
///
/// The word is at least 2⁶³.
#[function]
pub fn quotient_word(number: U128, divisor: u64) -> u64 {
    let (upper, lower) = (number.low >> 32, number.low & LOWER);
    let first = quotient_digit(number.high, upper, divisor);
    let rest = ((number.high << 32) | upper).wrapping_sub(first.wrapping_mul(divisor));
    (first << 32) | quotient_digit(rest, lower, divisor)
}

/// The quotient, rounded down; 0 for a divisor of 0.
#[function]
pub fn quotient(number: U128, divisor: U128) -> U128 {
    if number < divisor {
        return U128 { high: 0, low: 0 };
    }
    if divisor.high == 0 {
        if divisor.low == 0 {
            return U128 { high: 0, low: 0 };
        }
        if number.high == 0 {
            return U128 { high: 0, low: number.low / divisor.low };
        }
        let places = divisor.low.leading_zeros();
        let rest = U128 { high: number.high % divisor.low, low: number.low };
        return U128 {
            high: number.high / divisor.low,
            low: quotient_word(wrapping_shl(rest, places), divisor.low.wrapping_shl(places)),
        };
    }
    // The quotient is one word. Its estimate by the upper word of the divisor is too large by at most 1.
    let places = divisor.high.leading_zeros();
    let scaled = wrapping_shl(divisor, places);
    let estimate = quotient_word(wrapping_shr(number, 1), scaled.high);
    let low = estimate.wrapping_shr(63_u32.wrapping_sub(places)).wrapping_sub(1);
    let least = U128 { high: 0, low };
    let rest = wrapping_sub(number, wrapping_mul(least, divisor));
    if rest < divisor { least } else { U128 { high: 0, low: low.wrapping_add(1) } }
}

/// The remainder of the division; the number itself for a divisor of 0.
#[function]
pub fn remainder(number: U128, divisor: U128) -> U128 {
    wrapping_sub(number, wrapping_mul(quotient(number, divisor), divisor))
}

/// Returns true for the number 0.
#[function(expand)]
pub fn is_zero(number: U128) -> bool {
    number.high == 0 && number.low == 0
}

/// The sum.
///
/// # Panics
/// For a sum of more than 128 bits.
#[function(expand)]
pub fn sum(one: U128, other: U128) -> U128 {
    let overflows = sum_overflows(one, other);
    crate::__fits!(!overflows);
    wrapping_add(one, other)
}

/// The difference.
///
/// # Panics
/// For a difference below 0.
#[function(expand)]
pub fn difference(one: U128, other: U128) -> U128 {
    crate::__fits!(!(one < other));
    wrapping_sub(one, other)
}

/// The product.
///
/// # Panics
/// For a product of more than 128 bits.
#[function(expand)]
pub fn product(one: U128, other: U128) -> U128 {
    let overflows = product_overflows(one, other);
    crate::__fits!(!overflows);
    wrapping_mul(one, other)
}

/// The quotient, rounded down.
///
/// # Panics
/// For a divisor of 0.
#[function(expand)]
pub fn div(number: U128, divisor: U128) -> U128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    quotient(number, divisor)
}

/// The remainder.
///
/// # Panics
/// For a divisor of 0.
#[function(expand)]
pub fn rem(number: U128, divisor: U128) -> U128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    remainder(number, divisor)
}

macro_rules! shifts {
    ($($int:ident $up:ident $down:ident;)*) => {$(
        /// Moves the bits up.
        ///
        /// # Panics
        /// For fewer than 0 bits or more than 127.
        #[function(expand)]
        pub fn $up(number: U128, bits: $int) -> U128 {
            crate::__shifts!(bits as u64 <= 127);
            wrapping_shl(number, bits as u32)
        }

        /// Moves the bits down.
        ///
        /// # Panics
        /// For fewer than 0 bits or more than 127.
        #[function(expand)]
        pub fn $down(number: U128, bits: $int) -> U128 {
            crate::__shifts!(bits as u64 <= 127);
            wrapping_shr(number, bits as u32)
        }
    )*};
}

shifts! {
    i8 shl_i8 shr_i8;
    i16 shl_i16 shr_i16;
    i32 shl_i32 shr_i32;
    i64 shl_i64 shr_i64;
    isize shl_isize shr_isize;
    u8 shl_u8 shr_u8;
    u16 shl_u16 shr_u16;
    u64 shl_u64 shr_u64;
    usize shl_usize shr_usize;
}

/// Moves the bits up.
///
/// # Panics
/// For more than 127 bits.
#[function(expand)]
pub fn shl_u32(number: U128, bits: u32) -> U128 {
    crate::__shifts!(bits <= 127);
    wrapping_shl(number, bits)
}

/// Moves the bits down.
///
/// # Panics
/// For more than 127 bits.
#[function(expand)]
pub fn shr_u32(number: U128, bits: u32) -> U128 {
    crate::__shifts!(bits <= 127);
    wrapping_shr(number, bits)
}

/// The bits that are 1 in both numbers.
#[function(expand)]
pub fn both(one: U128, other: U128) -> U128 {
    U128 { high: one.high & other.high, low: one.low & other.low }
}

/// The bits that are 1 in at least one of the numbers.
#[function(expand)]
pub fn either(one: U128, other: U128) -> U128 {
    U128 { high: one.high | other.high, low: one.low | other.low }
}

/// The bits in which the two differ.
#[function(expand)]
pub fn differing(one: U128, other: U128) -> U128 {
    U128 { high: one.high ^ other.high, low: one.low ^ other.low }
}

/// The bits that a number does not have.
#[function(expand)]
pub fn opposite(number: U128) -> U128 {
    U128 { high: !number.high, low: !number.low }
}

macro_rules! words {
    ($($int:ident $of:ident $to:ident;)*) => {$(
        /// Widens a number.
        #[function(expand)]
        pub fn $of(number: $int) -> U128 {
            U128 { high: 0, low: number as u64 }
        }

        /// Keeps the lower bits.
        #[function(expand)]
        pub fn $to(number: U128) -> $int {
            number.low as $int
        }
    )*};
}

words! {
    u8 of_u8 to_u8;
    u16 of_u16 to_u16;
    u32 of_u32 to_u32;
    usize of_usize to_usize;
}

/// Widens a word.
#[function(expand)]
pub fn of_u64(number: u64) -> U128 {
    U128 { high: 0, low: number }
}

/// Keeps the lower word.
#[function(expand)]
pub fn to_u64(number: U128) -> u64 {
    number.low
}

/// Widens a truth to 0 or 1.
#[function(expand)]
pub fn of_bool(truth: bool) -> U128 {
    U128 { high: 0, low: truth as u64 }
}

/// Widens a character to its code point.
#[function(expand)]
pub fn of_char(character: char) -> U128 {
    U128 { high: 0, low: character as u64 }
}

macro_rules! signed {
    ($($int:ident $of:ident $to:ident;)*) => {$(
        /// Widens a number; the upper bits repeat its sign.
        #[function(expand)]
        pub fn $of(number: $int) -> U128 {
            U128 { high: if number < 0 { u64::MAX } else { 0 }, low: number as u64 }
        }

        /// Keeps the lower bits.
        #[function(expand)]
        pub fn $to(number: U128) -> $int {
            number.low as $int
        }
    )*};
}

signed! {
    i8 of_i8 to_i8;
    i16 of_i16 to_i16;
    i32 of_i32 to_i32;
    i64 of_i64 to_i64;
    isize of_isize to_isize;
}
