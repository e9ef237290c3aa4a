//! `x * a + b` with one rounding, on every machine.
//!
//! In double precision after S. Boldo and G. Melquiond, *Emulation of a FMA and correctly rounded sums: proved
//! algorithms using rounding to odd* (IEEE Transactions on Computers 57, 2008), where every step stays in the range
//! of normal numbers; otherwise with integers of 128 bits. In single precision the product is exact in double, and
//! the sum is rounded to odd before it is rounded to nearest. A correctly rounded result is unique, so a machine's
//! own instruction gives the same bits.

// A NaN goes the way of what is not less.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use super::RawBits as _;
use super::pair::{product, sum};
use super::reduction::upper_product;
use crate::prelude::*;

/// `a + b`, rounded to odd: an inexact sum becomes the neighbouring double whose last bit is 1.
#[inline]
#[function]
fn odd_sum(a: f64, b: f64) -> f64 {
    let near = sum(a, b);
    let bits = near.high.raw_bits();
    if near.low.abs() <= 0.0 || (bits & 1) == 1 {
        near.high
    } else if (near.low > 0.0) == (near.high > 0.0) {
        f64::from_bits(bits.wrapping_add(1))
    } else {
        f64::from_bits(bits.wrapping_sub(1))
    }
}

/// Returns true if a number is from 2^−`range` to 2^`range`.
#[inline]
#[function]
fn is_within(x: f64, range: u32) -> bool {
    let exponent = (x.raw_bits() >> 52) as u32 & 0x7ff;
    exponent.wrapping_sub(1023_u32.wrapping_sub(range)) < range.wrapping_add(range)
}

/// x · a + b, rounded once.
#[function]
pub fn mul_add(x: f64, a: f64, b: f64) -> f64 {
    if is_within(x, 250) && is_within(a, 250) && is_within(b, 450) {
        let product = product(x, a);
        let lower = sum(b, product.low);
        let upper = sum(product.high, lower.high);
        upper.high + odd_sum(lower.low, upper.low)
    } else {
        far_mul_add(x, a, b)
    }
}

/// The positive number (`high` · 2⁶⁴ + `low`) · 2^`exponent`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide {
    /// The upper 64 bits.
    pub high: u64,
    /// The lower 64 bits.
    pub low: u64,
    /// Exponent of the number's last bit.
    pub exponent: i32,
}

/// The significand of a finite number other than zero, shifted so that its leading bit is the highest, and the
/// exponent of its last bit.
#[function]
pub fn whole(x: f64) -> Wide {
    let bits = x.raw_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = bits & 0x000f_ffff_ffff_ffff;
    if exponent == 0 {
        let zeros = fraction.leading_zeros();
        let high = fraction << (zeros & 63);
        Wide { high, low: 0, exponent: (-1074_i32).wrapping_sub(zeros as i32) }
    } else {
        let high = (fraction | 0x0010_0000_0000_0000) << 11;
        Wide { high, low: 0, exponent: exponent.wrapping_sub(1023 + 52 + 11) }
    }
}

/// The number without its last `count` bits; its new last bit is 1 if one of them was.
#[function]
pub fn shifted_right(number: Wide, count: i32) -> Wide {
    let exponent = number.exponent.wrapping_add(count);
    let places = (count & 63) as u32;
    let back = (64_u32.wrapping_sub(places)) & 63;
    if count <= 0 {
        number
    } else if count < 64 {
        let gone = number.low << back;
        let low = (number.low >> places) | (number.high << back);
        Wide { high: number.high >> places, low: if gone == 0 { low } else { low | 1 }, exponent }
    } else if count == 64 {
        let low = if number.low == 0 { number.high } else { number.high | 1 };
        Wide { high: 0, low, exponent }
    } else if count < 128 {
        let gone = (number.high << back) | number.low;
        let low = number.high >> places;
        Wide { high: 0, low: if gone == 0 { low } else { low | 1 }, exponent }
    } else {
        Wide { high: 0, low: 1, exponent }
    }
}

/// The number shifted so that its leading bit is the highest.
#[function]
pub fn normalized(number: Wide) -> Wide {
    let high = if number.high == 0 { number.low } else { number.high };
    let low = if number.high == 0 { 0 } else { number.low };
    let moved = if number.high == 0 { 64 } else { 0 };
    let zeros = high.leading_zeros() & 63;
    Wide {
        high: (high << zeros) | ((low >> 1) >> (63_u32.wrapping_sub(zeros) & 63)),
        low: low << zeros,
        exponent: number.exponent.wrapping_sub(zeros as i32).wrapping_sub(moved),
    }
}

/// The number rounded to the nearest double.
#[function]
pub fn nearest(number: Wide) -> f64 {
    let normal = normalized(number);
    // The exponent as it is stored; below 1 the number is subnormal.
    let stored = normal.exponent.wrapping_add(127 + 1023);
    let number = shifted_right(normal, 1_i32.wrapping_sub(stored));
    let mut bits = number.high >> 11;
    if stored > 1 {
        if stored > 2046 {
            return f64::INFINITY;
        }
        bits = bits.wrapping_add((stored.wrapping_sub(1) as u32 as u64) << 52);
    }
    let rest = ((number.high & 0x7ff) << 53) | (number.low >> 11) | (number.low & 0x7ff);
    let half = 0x8000_0000_0000_0000;
    if rest > half || (rest == half && (bits & 1) == 1) {
        bits = bits.wrapping_add(1);
    }
    f64::from_bits(bits)
}

/// x · a + b, rounded once, for all numbers.
#[function]
pub fn far_mul_add(x: f64, a: f64, b: f64) -> f64 {
    // Both are false for a NaN.
    let finite = x.abs() <= f64::MAX && a.abs() <= f64::MAX;
    if finite && !(b.abs() <= f64::MAX) {
        return b;
    }
    if !finite || x.abs() <= 0.0 || a.abs() <= 0.0 {
        return x * a + b;
    }
    if b.abs() <= 0.0 {
        return x * a;
    }
    let first = whole(x);
    let second = whole(a);
    // Two bits of room: neither number has that many in the last places.
    let product = shifted_right(
        Wide {
            high: upper_product(first.high, second.high),
            low: first.high.wrapping_mul(second.high),
            exponent: first.exponent.wrapping_add(second.exponent),
        },
        2,
    );
    let third = whole(b);
    let addend = shifted_right(Wide { exponent: third.exponent.wrapping_sub(64), ..third }, 2);
    let product_negative = (x < 0.0) != (a < 0.0);
    let apart = product.exponent.wrapping_sub(addend.exponent);
    let product = shifted_right(product, 0_i32.wrapping_sub(apart));
    let addend = shifted_right(addend, apart);
    let product_larger =
        product.high > addend.high || (product.high == addend.high && product.low > addend.low);
    let large = if product_larger { product } else { addend };
    let small = if product_larger { addend } else { product };
    let negative = if product_larger { product_negative } else { b < 0.0 };
    let total = if product_negative == (b < 0.0) {
        let low = large.low.wrapping_add(small.low);
        let carry = if low < small.low { 1 } else { 0 };
        Wide { high: large.high.wrapping_add(small.high).wrapping_add(carry), low, ..large }
    } else {
        let borrow = if large.low < small.low { 1 } else { 0 };
        Wide {
            high: large.high.wrapping_sub(small.high).wrapping_sub(borrow),
            low: large.low.wrapping_sub(small.low),
            ..large
        }
    };
    if total.high == 0 && total.low == 0 {
        return 0.0;
    }
    let value = nearest(total);
    if negative { -value } else { value }
}

/// x · a + b in single precision, rounded once.
#[function]
pub fn mul_addf(x: f32, a: f32, b: f32) -> f32 {
    let product = x as f64 * a as f64;
    let addend = b as f64;
    let total = product + addend;
    // Infinities and NaN.
    if !(total.abs() <= f64::MAX) {
        return total as f32;
    }
    odd_sum(product, addend) as f32
}
