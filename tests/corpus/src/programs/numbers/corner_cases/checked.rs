//! Checked arithmetic of every integer type.

use bessemer::prelude::*;

/// A component without state.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Checked {
    pub calls: u8,
}

#[component]
impl Checked {
    #[entry(infallible)]
    pub fn all_i8(&self, a: i8, b: i8, n: u32) -> [Option<i8>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_i16(&self, a: i16, b: i16, n: u32) -> [Option<i16>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_i32(&self, a: i32, b: i32, n: u32) -> [Option<i32>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_i64(&self, a: i64, b: i64, n: u32) -> [Option<i64>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_isize(&self, a: isize, b: isize, n: u32) -> [Option<isize>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_u8(&self, a: u8, b: u8, n: u32) -> [Option<u8>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_u16(&self, a: u16, b: u16, n: u32) -> [Option<u16>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_u32(&self, a: u32, b: u32, n: u32) -> [Option<u32>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_u64(&self, a: u64, b: u64, n: u32) -> [Option<u64>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn all_usize(&self, a: usize, b: usize, n: u32) -> [Option<usize>; 9] {
        [
            a.checked_add(b),
            a.checked_sub(b),
            a.checked_mul(b),
            a.checked_div(b),
            a.checked_rem(b),
            a.checked_neg(),
            a.checked_shl(n),
            a.checked_shr(n),
            a.checked_pow(n),
        ]
    }

    #[entry(infallible)]
    pub fn magnitudes(&self, a: i8, b: i64) -> (Option<i8>, Option<i64>) {
        (a.checked_abs(), b.checked_abs())
    }
}
