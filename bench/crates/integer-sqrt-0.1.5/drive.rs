//! Calls of `integer-sqrt` over plain numbers.

use crate::*;

pub fn of_u8(n: u8) -> u8 {
    n.integer_sqrt()
}

pub fn of_i16(n: i16) -> Option<i16> {
    n.integer_sqrt_checked()
}

pub fn of_u32(n: u32) -> u32 {
    n.integer_sqrt()
}

pub fn of_i32(n: i32) -> i32 {
    n.integer_sqrt()
}

pub fn of_u64(n: u64) -> u64 {
    n.integer_sqrt()
}

pub fn of_i64(n: i64) -> Option<i64> {
    n.integer_sqrt_checked()
}
