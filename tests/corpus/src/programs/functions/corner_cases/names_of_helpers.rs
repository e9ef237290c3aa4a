//! Names that the C's own helpers have; and a comment with what C takes for another sign: ???/
//! at its end.

use bessemer::prelude::*;

/// Is it less???/
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Min {
    pub low: u8,
}

#[data]
impl Min {
    pub fn u8(&self, other: u8) -> u8 {
        self.low.min(other)
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrap {
    pub bits: u32,
}

#[data]
impl Wrap {
    pub fn i32(&self) -> i32 {
        (self.bits as i32).wrapping_add(1)
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct U32 {
    pub value: u32,
}

#[data]
impl U32 {
    pub fn from_f64(x: f64) -> U32 {
        U32 { value: x as u32 }
    }
}

#[function]
pub fn named(low: u8, other: u8, bits: u32, x: f64) -> u32 {
    let wrapped = Wrap { bits }.i32() as u32;
    u32::from(Min { low }.u8(other)) ^ wrapped ^ U32::from_f64(x).value
}

/// Locals with the names of helper functions.
#[function]
pub fn locals(a: u8, b: u8, c: i8) -> u32 {
    let xor_u8 = a.wrapping_add(1);
    let wrap_i32 = c.wrapping_neg();
    let bits_of_f64 = u32::from(xor_u8 ^ b) + u32::from((a ^ b) > 3);
    bits_of_f64.wrapping_add(wrap_i32 as u32)
}

/// A loop downwards from a number that was converted to a signed type.
#[function]
pub fn downwards(m: u8, n: i16) -> i32 {
    let mut sum = 0_i32;
    for i in (0..=(m as i32)).rev() {
        sum = sum.wrapping_mul(3).wrapping_add(i);
    }
    for i in (0..=(i32::from(n) & 63)).rev() {
        sum ^= i;
    }
    for i in (-3..=i64::from(m)).rev() {
        sum = sum.wrapping_sub(i as i32);
    }
    sum
}
