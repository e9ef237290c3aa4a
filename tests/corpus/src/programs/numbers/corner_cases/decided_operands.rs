//! Operations whose result one constant determines, whatever the other operand is. Compilers know that, and warn of
//! certain faults although a check precedes them.
#![allow(unconditional_panic, arithmetic_overflow, clippy::all)]

use bessemer::prelude::*;

#[function]
pub fn by_nothing(x: u32, y: u32, n: i16) -> u32 {
    if n < 0 {
        return x % (y & 0);
    }
    if n < 10 {
        return x / (y * 0);
    }
    if n < 20 {
        return x % (y - y);
    }
    if n < 30 {
        return x / (y % 1);
    }
    x / ((y ^ y) + 2)
}

#[function]
pub fn signed_by_nothing(x: i32, y: i32) -> i32 {
    match y & 3 {
        0 => x / (y % -1),
        1 => x % (0 & y),
        2 => x / (y % 1),
        _ => x / (y | -1),
    }
}

#[function]
pub fn too_far(x: u32, y: u8, n: u8) -> u32 {
    if n > 9 {
        return x << (y | 255);
    }
    if n > 4 {
        return x >> (y | 255);
    }
    x << (y % 1)
}

#[function]
pub fn signed_too_far(x: i64, y: u32, n: u8) -> i64 {
    if n > 9 {
        return x << (y | u32::MAX);
    }
    x >> (y | u32::MAX)
}

/// Comparisons with known results.
#[function]
pub fn compared(y: u16, z: i8) -> [bool; 6] {
    [(y & 0) == 0, y % 1 > 0, (y | u16::MAX) == u16::MAX, z * 0 != 0, z % -1 <= 0, (y * 0) < (y & 0)]
}

/// Numbers converted from `bool`.
#[function]
pub fn flags(flag: bool, other: bool) -> [bool; 6] {
    [
        flag as u8 > 1,
        (flag as u8 & 1) > 1,
        (flag as u32) * 1 >= 2,
        (flag as i16 | other as i16) == 2,
        (flag as u8 + 0) != 7,
        ((flag & other) as i32) < -1,
    ]
}

/// Number of bits that differ, counted one after another.
#[function]
fn bits_that_differ(x: u32, y: u32) -> u8 {
    let (mut rest, mut count) = (x ^ y, 0);
    for _ in 0..32 {
        count += (rest & 1) as u8;
        rest >>= 1;
    }
    count
}

/// A call whose result is not needed, since the operation's result is known.
#[function]
pub fn asked_for_nothing(x: u32, y: u32) -> bool {
    bits_that_differ(x, y) % 1 == 0
}

/// A number that is used only in operations with known results.
#[function]
pub fn counted_for_nothing(x: &[u8; 4]) -> bool {
    let mut count = 0_u32;
    for it in x {
        if *it > 3 {
            count += 1;
        }
    }
    count & 0 == 0
}
