//! Rust's `i128` in the C.

use super::methods::methods;
use super::u128::{self as unsigned, U128};
use crate::Plain;
use crate::prelude::*;

/// A signed integer of 128 bits, in two's complement.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct I128 {
    /// The upper 64 bits, with the sign.
    pub high: i64,
    /// The lower 64 bits.
    pub low: u64,
}

/// The words are the upper and the lower 64 bits.
#[diagnostic::do_not_recommend]
impl Plain for ::core::primitive::i128 {
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

/// The number of the same bits without a sign.
#[function(expand)]
pub fn to_u128(number: I128) -> U128 {
    U128 { high: number.high as u64, low: number.low }
}

/// The number of the same bits with a sign.
#[function(expand)]
pub fn of_u128(number: U128) -> I128 {
    I128 { high: number.high as i64, low: number.low }
}

/// Returns true for a number below 0.
#[function(expand)]
pub fn is_negative(number: I128) -> bool {
    number.high < 0
}

/// Returns true for a number above 0.
#[function(expand)]
pub fn is_positive(number: I128) -> bool {
    number.high > 0 || (number.high == 0 && number.low != 0)
}

/// Returns true for the number 0.
#[function(expand)]
pub fn is_zero(number: I128) -> bool {
    number.high == 0 && number.low == 0
}

/// Returns true for the least number, which has no opposite.
#[function(expand)]
pub fn is_least(number: I128) -> bool {
    number.high == i64::MIN && number.low == 0
}

/// The least number, or else the greatest.
#[function(expand)]
pub fn limit(least: bool) -> I128 {
    if least { I128 { high: i64::MIN, low: 0 } } else { I128 { high: i64::MAX, low: u64::MAX } }
}

/// The sum of two words.
#[function]
#[inline]
pub fn sum_of_words(one: i64, other: i64) -> I128 {
    let low = (one as u64).wrapping_add(other as u64);
    let carry = i64::from(low < one as u64);
    I128 { high: (one >> 63) + (other >> 63) + carry, low }
}

/// The difference of two words.
#[function]
#[inline]
pub fn difference_of_words(one: i64, other: i64) -> I128 {
    let borrow = i64::from((one as u64) < other as u64);
    I128 {
        high: (one >> 63) - (other >> 63) - borrow,
        low: (one as u64).wrapping_sub(other as u64),
    }
}

/// The product of two words.
#[function]
#[inline]
pub fn product_of_words(one: i64, other: i64) -> I128 {
    let product = unsigned::product_of_words(one as u64, other as u64);
    let high = (product.high as i64).wrapping_sub((one >> 63) & other);
    I128 { high: high.wrapping_sub((other >> 63) & one), low: product.low }
}

/// The sum of two numbers of 32 bits.
#[function(expand)]
pub fn sum_of_halves(one: i32, other: i32) -> I128 {
    of_i64(i64::from(one) + i64::from(other))
}

/// The difference of two numbers of 32 bits.
#[function(expand)]
pub fn difference_of_halves(one: i32, other: i32) -> I128 {
    of_i64(i64::from(one) - i64::from(other))
}

/// The product of two numbers of 32 bits.
#[function(expand)]
pub fn product_of_halves(one: i32, other: i32) -> I128 {
    of_i64(i64::from(one) * i64::from(other))
}

/// The sum, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_add(one: I128, other: I128) -> I128 {
    let low = one.low.wrapping_add(other.low);
    let carry = i64::from(low < one.low);
    I128 { high: one.high.wrapping_add(other.high).wrapping_add(carry), low }
}

/// The difference, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_sub(one: I128, other: I128) -> I128 {
    let borrow = i64::from(one.low < other.low);
    I128 {
        high: one.high.wrapping_sub(other.high).wrapping_sub(borrow),
        low: one.low.wrapping_sub(other.low),
    }
}

/// The negative, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_neg(number: I128) -> I128 {
    let borrow = i64::from(number.low != 0);
    I128 {
        high: 0_i64.wrapping_sub(number.high).wrapping_sub(borrow),
        low: 0_u64.wrapping_sub(number.low),
    }
}

/// The product, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_mul(one: I128, other: I128) -> I128 {
    of_u128(unsigned::wrapping_mul(to_u128(one), to_u128(other)))
}

/// The magnitude.
#[function]
#[inline]
pub fn unsigned_abs(number: I128) -> U128 {
    if number.high < 0 { to_u128(wrapping_neg(number)) } else { to_u128(number) }
}

/// Returns true if the sum of two numbers needs more than 128 bits.
#[function]
#[inline]
pub fn sum_overflows(one: I128, other: I128) -> bool {
    (other.high < 0) != (wrapping_add(one, other) < one)
}

/// Returns true if the difference of two numbers needs more than 128 bits.
#[function]
#[inline]
pub fn difference_overflows(one: I128, other: I128) -> bool {
    (other.high < 0) != (one < wrapping_sub(one, other))
}

/// Returns true if the product of two numbers needs more than 128 bits.
#[function]
#[inline]
pub fn product_overflows(one: I128, other: I128) -> bool {
    let (a, b) = (unsigned_abs(one), unsigned_abs(other));
    let product = unsigned::wrapping_mul(a, b);
    // The least number has one more than the greatest.
    let least = (one.high < 0) != (other.high < 0) && product.high == 1 << 63 && product.low == 0;
    unsigned::product_overflows(a, b) || (product.high >> 63 == 1 && !least)
}

/// Returns true if a quotient needs more than 128 bits.
#[function(expand)]
pub fn quotient_overflows(number: I128, divisor: I128) -> bool {
    is_least(number) && divisor.high == -1 && divisor.low == u64::MAX
}

/// Moves the bits up, by `bits` modulo 128.
#[function]
#[inline]
pub fn wrapping_shl(number: I128, bits: u32) -> I128 {
    of_u128(unsigned::wrapping_shl(to_u128(number), bits))
}

/// Moves the bits down, by `bits` modulo 128; the sign stays.
#[function]
#[inline]
pub fn wrapping_shr(number: I128, bits: u32) -> I128 {
    let within = bits & 63;
    let high = number.high >> within;
    let low = (number.low >> within) | (((number.high as u64) << 1) << (63 - within));
    if bits & 64 == 0 {
        I128 { high, low }
    } else {
        I128 { high: number.high >> 63, low: high as u64 }
    }
}

/// Moves the bits down, by `bits` modulo 128, with zeros above.
#[function(expand)]
pub fn logical_shr(number: I128, bits: u32) -> I128 {
    of_u128(unsigned::wrapping_shr(to_u128(number), bits))
}

/// The quotient, rounded towards 0 and wrapped to 128 bits; 0 for a divisor of 0.
#[function]
pub fn quotient(number: I128, divisor: I128) -> I128 {
    let magnitude = of_u128(unsigned::quotient(unsigned_abs(number), unsigned_abs(divisor)));
    if (number.high < 0) == (divisor.high < 0) { magnitude } else { wrapping_neg(magnitude) }
}

/// The remainder of that division; the number itself for a divisor of 0.
#[function]
pub fn remainder(number: I128, divisor: I128) -> I128 {
    wrapping_sub(number, wrapping_mul(quotient(number, divisor), divisor))
}

/// The sum.
///
/// # Panics
/// For a sum of more than 128 bits.
#[function(expand)]
pub fn sum(one: I128, other: I128) -> I128 {
    let sum = checked_add(one, other);
    crate::__fits!(sum.is_some());
    sum.unwrap()
}

/// The difference.
///
/// # Panics
/// For a difference of more than 128 bits.
#[function(expand)]
pub fn difference(one: I128, other: I128) -> I128 {
    let difference = checked_sub(one, other);
    crate::__fits!(difference.is_some());
    difference.unwrap()
}

/// The product.
///
/// # Panics
/// For a product of more than 128 bits.
#[function(expand)]
pub fn product(one: I128, other: I128) -> I128 {
    let product = checked_mul(one, other);
    crate::__fits!(product.is_some());
    product.unwrap()
}

/// The quotient, rounded towards 0.
///
/// # Panics
/// For a divisor of 0, and for the least number divided by -1.
#[function(expand)]
pub fn div(number: I128, divisor: I128) -> I128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    crate::__fits!(
        !(divisor.high == -1
            && divisor.low == u64::MAX
            && number.high == i64::MIN
            && number.low == 0)
    );
    quotient(number, divisor)
}

/// The remainder, with the sign of the number.
///
/// # Panics
/// For a divisor of 0, and for the least number divided by -1.
#[function(expand)]
pub fn rem(number: I128, divisor: I128) -> I128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    crate::__fits!(
        !(divisor.high == -1
            && divisor.low == u64::MAX
            && number.high == i64::MIN
            && number.low == 0)
    );
    remainder(number, divisor)
}

/// The negative.
///
/// # Panics
/// For the least number.
#[function(expand)]
pub fn negative(number: I128) -> I128 {
    crate::__fits!(!(number.high == i64::MIN && number.low == 0));
    wrapping_neg(number)
}

/// The magnitude.
///
/// # Panics
/// For the least number.
#[function(expand)]
pub fn abs(number: I128) -> I128 {
    crate::__fits!(!(number.high == i64::MIN && number.low == 0));
    wrapping_abs(number)
}

/// The magnitude, wrapped to 128 bits.
#[function]
#[inline]
pub fn wrapping_abs(number: I128) -> I128 {
    if number.high < 0 { wrapping_neg(number) } else { number }
}

/// The sign as -1, 0 or 1.
#[function]
#[inline]
pub fn signum(number: I128) -> I128 {
    if number.high < 0 {
        I128 { high: -1, low: u64::MAX }
    } else {
        I128 { high: 0, low: u64::from(number.high != 0 || number.low != 0) }
    }
}

/// `-a`; `None` for the least number.
#[function]
pub fn checked_neg(a: I128) -> Option<I128> {
    if is_least(a) { None } else { Some(wrapping_neg(a)) }
}

/// `|a|`; `None` for the least number.
#[function]
pub fn checked_abs(a: I128) -> Option<I128> {
    if is_least(a) { None } else { Some(wrapping_abs(a)) }
}

/// The magnitude of the difference.
#[function]
#[inline]
pub fn abs_diff(one: I128, other: I128) -> U128 {
    if one < other { to_u128(wrapping_sub(other, one)) } else { to_u128(wrapping_sub(one, other)) }
}

/// The quotient with a remainder of 0 or more, wrapped to 128 bits.
#[function]
pub fn quotient_euclid(number: I128, divisor: I128) -> I128 {
    let quotient = quotient(number, divisor);
    if remainder(number, divisor).high >= 0 {
        return quotient;
    }
    let one = I128 { high: 0, low: 1 };
    if divisor.high < 0 { wrapping_add(quotient, one) } else { wrapping_sub(quotient, one) }
}

/// The remainder of 0 or more.
#[function]
pub fn remainder_euclid(number: I128, divisor: I128) -> I128 {
    let rest = remainder(number, divisor);
    if rest.high < 0 { wrapping_add(rest, wrapping_abs(divisor)) } else { rest }
}

/// The quotient with a remainder of 0 or more.
///
/// # Panics
/// For a divisor of 0, and for the least number divided by -1.
#[function(expand)]
pub fn div_euclid(number: I128, divisor: I128) -> I128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    crate::__fits!(
        !(divisor.high == -1
            && divisor.low == u64::MAX
            && number.high == i64::MIN
            && number.low == 0)
    );
    quotient_euclid(number, divisor)
}

/// The remainder of 0 or more.
///
/// # Panics
/// For a divisor of 0, and for the least number divided by -1.
#[function(expand)]
pub fn rem_euclid(number: I128, divisor: I128) -> I128 {
    crate::__divides!(divisor.high != 0 || divisor.low != 0);
    crate::__fits!(
        !(divisor.high == -1
            && divisor.low == u64::MAX
            && number.high == i64::MIN
            && number.low == 0)
    );
    remainder_euclid(number, divisor)
}

methods! { I128: i64 }

/// Returns true if a number is a value of a type of at most 64 bits with this range.
#[function(expand)]
pub fn is_within(number: I128, least: i64, greatest: u64) -> bool {
    if least < 0 {
        let below = number.high == -1 && number.low >= least as u64;
        below || (number.high == 0 && number.low <= greatest)
    } else {
        number.high == 0 && number.low <= greatest
    }
}

macro_rules! widenings {
    ($($int:ident $of:ident;)*) => {$(
        /// Widens a number.
        #[function(expand)]
        pub fn $of(number: $int) -> I128 {
            I128 { high: 0, low: number as u64 }
        }
    )*};
}

widenings! {
    bool of_bool;
    u8 of_u8;
    u16 of_u16;
    u32 of_u32;
    u64 of_u64;
    usize of_usize;
}

macro_rules! signed {
    ($($int:ident $of:ident;)*) => {$(
        /// Widens a number; the upper bits repeat its sign.
        #[function(expand)]
        pub fn $of(number: $int) -> I128 {
            I128 { high: if number < 0 { -1 } else { 0 }, low: number as u64 }
        }
    )*};
}

signed! {
    i8 of_i8;
    i16 of_i16;
    i32 of_i32;
    i64 of_i64;
    isize of_isize;
}

/// Widens a size.
///
/// # Errors
/// None: every size fits.
#[function]
#[allow(clippy::result_unit_err)]
pub fn try_of_usize(number: usize) -> Result<I128, ()> {
    Ok(I128 { high: 0, low: number as u64 })
}

/// Widens a difference of sizes.
///
/// # Errors
/// None: every one fits.
#[function]
#[allow(clippy::result_unit_err)]
pub fn try_of_isize(number: isize) -> Result<I128, ()> {
    Ok(of_isize(number))
}

/// The number with a sign, if it fits.
///
/// # Errors
/// A number that does not fit.
#[function]
#[allow(clippy::result_unit_err)]
pub fn try_of_u128(number: U128) -> Result<I128, ()> {
    if number.high >> 63 == 1 { Err(()) } else { Ok(of_u128(number)) }
}

/// The number without a sign, if it fits.
///
/// # Errors
/// A number below 0.
#[function]
#[allow(clippy::result_unit_err)]
pub fn try_to_u128(number: I128) -> Result<U128, ()> {
    if number.high < 0 { Err(()) } else { Ok(to_u128(number)) }
}

/// Rounds a number towards 0, or to the nearest value of the type; 0 for a NaN.
#[function]
pub fn of_f64(number: f64) -> I128 {
    let magnitude = unsigned::of_f64(number.abs());
    let negative = number < 0.0;
    if magnitude.high >> 63 == 1 {
        return limit(negative);
    }
    if negative { wrapping_neg(of_u128(magnitude)) } else { of_u128(magnitude) }
}

/// Rounds a number towards 0, or to the nearest value of the type; 0 for a NaN.
#[function(expand)]
pub fn of_f32(number: f32) -> I128 {
    of_f64(f64::from(number))
}
