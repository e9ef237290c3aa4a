//! Assignments of a variable to itself, which change nothing and for which compilers warn.

use bessemer::prelude::*;

#[function]
pub fn of_numbers(mut n: u8, mut flag: bool, mut x: f64) -> (u8, bool, f64) {
    n = n;
    n |= n;
    n &= n;
    n = n as u8;
    n = (n | n) & n;
    flag = flag;
    flag |= flag;
    flag &= flag;
    x = x;
    x = x as f64;
    (n, flag, x)
}

/// Similar assignments that do change something.
#[function]
pub fn changed(mut n: i16, mut flag: bool) -> (i16, bool) {
    n ^= n;
    n |= n + 1;
    n = n as u8 as i16;
    n = (n as u16 >> 1) as i16;
    flag |= !flag;
    (n, flag)
}

#[function]
pub fn of_parts(list: &mut [u32; 4], i: usize, j: usize) {
    list[i] |= list[i];
    list[j] &= list[j];
    list[i] = list[j] | list[j];
    list[0] |= list[0];
}

/// Variables that nothing else reads.
#[function]
pub fn alone(mut n: u32, list: &mut [i8; 2]) {
    n |= n;
    list[1] &= list[1];
}

/// Variables that are set and never read.
#[function]
pub fn set(mut n: u32, mut flag: bool, mut x: f32) -> u8 {
    n = 3;
    flag = flag;
    if flag {
        x = 2.0;
    }
    1
}

/// A comparison of a variable with itself is known, so it is not in the C.
#[function]
pub fn at_most_itself(x: i8) -> bool {
    (x as u32) <= (x as u32)
}

/// `^` of two `bool`s is `!=` in the C; of a variable with itself it is `false`, since compilers warn for that
/// comparison.
#[function]
pub fn cleared(mut flag: bool, flags: &mut [bool; 3], i: usize) -> (bool, bool, bool) {
    let other = flag ^ flag;
    flags[i] ^= flags[i];
    flags[0] ^= !flags[0];
    let both = flag ^ flags[1] ^ true;
    flag ^= flag;
    (flag, other, both)
}

/// A variable that nothing else reads.
#[function]
pub fn cleared_alone(mut flag: bool) -> u8 {
    flag ^= flag;
    2
}
