//! Rust's `u128` in the C.

use super::methods::methods;
use super::u128 as unsigned;
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
    let sum = checked_add(one, other);
    crate::__fits!(sum.is_some());
    sum.unwrap()
}

/// The difference.
///
/// # Panics
/// For a difference below 0.
#[function(expand)]
pub fn difference(one: U128, other: U128) -> U128 {
    let difference = checked_sub(one, other);
    crate::__fits!(difference.is_some());
    difference.unwrap()
}

/// The product.
///
/// # Panics
/// For a product of more than 128 bits.
#[function(expand)]
pub fn product(one: U128, other: U128) -> U128 {
    let product = checked_mul(one, other);
    crate::__fits!(product.is_some());
    product.unwrap()
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

methods! { U128: u64 }

/// Returns false: no number is below 0.
#[function(expand)]
pub fn is_negative(_number: U128) -> bool {
    false
}

/// The number itself.
#[function(expand)]
pub fn unsigned_abs(number: U128) -> U128 {
    number
}

/// Returns true if the difference of two numbers is below 0.
#[function(expand)]
pub fn difference_overflows(one: U128, other: U128) -> bool {
    one < other
}

/// Returns false: no quotient is greater than its dividend.
#[function(expand)]
pub fn quotient_overflows(_number: U128, _divisor: U128) -> bool {
    false
}

/// Returns true if a number is a value of a type of at most 64 bits with this greatest value.
#[function(expand)]
pub fn is_within(number: U128, _least: i64, greatest: u64) -> bool {
    number.high == 0 && number.low <= greatest
}

/// The number 0, or else the greatest.
#[function(expand)]
pub fn limit(least: bool) -> U128 {
    if least { U128 { high: 0, low: 0 } } else { U128 { high: u64::MAX, low: u64::MAX } }
}

/// Moves the bits down, by `bits` modulo 128, with zeros above.
#[function(expand)]
pub fn logical_shr(number: U128, bits: u32) -> U128 {
    wrapping_shr(number, bits)
}

/// The negative, wrapped to 128 bits.
#[function(expand)]
pub fn wrapping_neg(number: U128) -> U128 {
    wrapping_sub(U128 { high: 0, low: 0 }, number)
}

/// `-a`; `None` unless it is 0.
#[function]
pub fn checked_neg(a: U128) -> Option<U128> {
    if is_zero(a) { Some(a) } else { None }
}

/// The magnitude of the difference.
#[function]
#[inline]
pub fn abs_diff(one: U128, other: U128) -> U128 {
    if one < other { wrapping_sub(other, one) } else { wrapping_sub(one, other) }
}

/// Returns true for a power of two.
#[function(expand)]
pub fn is_power_of_two(number: U128) -> bool {
    count_ones(number) == 1
}

/// The position of the highest bit; `None` for 0.
#[function]
pub fn checked_ilog2(number: U128) -> Option<u32> {
    if is_zero(number) { None } else { Some(127_u32.wrapping_sub(leading_zeros(number))) }
}

/// The position of the highest bit.
///
/// # Panics
/// For the number 0.
#[function(expand)]
pub fn ilog2(number: U128) -> u32 {
    assert!(number.high != 0 || number.low != 0);
    127_u32.wrapping_sub(leading_zeros(number))
}

/// The square root, rounded down: one bit after another, from the highest.
#[function]
pub fn isqrt(number: U128) -> U128 {
    let mut rest = number;
    let mut root = U128 { high: 0, low: 0 };
    for step in 1..=64_u32 {
        let bit = wrapping_shl(U128 { high: 0, low: 1 }, 128 - 2 * step);
        let tried = wrapping_add(root, bit);
        root = wrapping_shr(root, 1);
        if !(rest < tried) {
            rest = wrapping_sub(rest, tried);
            root = wrapping_add(root, bit);
        }
    }
    root
}

macro_rules! widenings {
    ($($int:ident $of:ident;)*) => {$(
        /// Widens a number.
        #[function(expand)]
        pub fn $of(number: $int) -> U128 {
            U128 { high: 0, low: number as u64 }
        }
    )*};
}

widenings! {
    bool of_bool;
    char of_char;
    u8 of_u8;
    u16 of_u16;
    u32 of_u32;
    u64 of_u64;
    usize of_usize;
}

macro_rules! signed {
    ($($int:ident $of:ident $try_of:ident;)*) => {$(
        /// Widens a number; the upper bits repeat its sign.
        #[function(expand)]
        pub fn $of(number: $int) -> U128 {
            U128 { high: if number < 0 { u64::MAX } else { 0 }, low: number as u64 }
        }

        /// Widens a number that is not below 0.
        ///
        /// # Errors
        /// A number below 0.
        #[function]
        #[allow(clippy::result_unit_err)]
        pub fn $try_of(number: $int) -> Result<U128, ()> {
            if number < 0 { Err(()) } else { Ok(U128 { high: 0, low: number as u64 }) }
        }
    )*};
}

signed! {
    i8 of_i8 try_of_i8;
    i16 of_i16 try_of_i16;
    i32 of_i32 try_of_i32;
    i64 of_i64 try_of_i64;
    isize of_isize try_of_isize;
}

/// Widens a size.
///
/// # Errors
/// None: every size fits.
#[function]
#[allow(clippy::result_unit_err)]
pub fn try_of_usize(number: usize) -> Result<U128, ()> {
    Ok(U128 { high: 0, low: number as u64 })
}

/// Rounds a number towards 0, or to the nearest value of the type; 0 for a NaN.
#[function]
pub fn of_f64(number: f64) -> U128 {
    if !(number >= 1.0) {
        return U128 { high: 0, low: 0 };
    }
    if number >= 340_282_366_920_938_463_463_374_607_431_768_211_456.0 {
        return U128 { high: u64::MAX, low: u64::MAX };
    }
    if number < 18_446_744_073_709_551_616.0 {
        return U128 { high: 0, low: number as u64 };
    }
    // A whole number of 53 bits has the exponent 1075.
    let bits = number.to_bits();
    let whole = (bits & 0xF_FFFF_FFFF_FFFF) | 0x10_0000_0000_0000;
    wrapping_shl(U128 { high: 0, low: whole }, ((bits >> 52) as u32).wrapping_sub(1075))
}

/// Rounds a number towards 0, or to the nearest value of the type; 0 for a NaN.
#[function(expand)]
pub fn of_f32(number: f32) -> U128 {
    of_f64(f64::from(number))
}
