//! Chained arrays: empty ones, names that hide others, early exits, and the order of faults.

use bessemer::prelude::*;

/// Three sequences, parts of slices, an index over all, and a `break`.
#[function]
pub fn parts(a: &[i32; 4], b: &List<i32, 3>, from: usize, stop: i32) -> (i32, usize) {
    let mut sum = 0;
    let mut seen = 0;
    let element = 5;
    for (i, x) in a[from..].iter().chain(b).chain(&a[..2]).enumerate() {
        if *x == stop {
            break;
        }
        if i == 3 {
            continue;
        }
        sum ^= x + element;
        seen = i;
    }
    (sum, seen)
}

/// Chains with skipped items at both ends, and reversed.
#[function]
pub fn cut(a: &[u8; 3], b: &[u8; 3], n: usize) -> [u32; 3] {
    let mut sums = [0; 3];
    for x in a.iter().chain(b.iter()).skip(n).take(2) {
        sums[0] = 2 * sums[0] + u32::from(*x);
    }
    for x in a.iter().chain(b.iter()).rev().take(n) {
        sums[1] = 2 * sums[1] % 1000 + u32::from(*x);
    }
    for (x, y) in a.iter().chain(b).zip(b.iter().step_by(2)) {
        sums[2] = 2 * sums[2] + u32::from(x ^ y);
    }
    sums
}

/// The found element is a copy; a fault occurs at the element that causes it.
#[function]
pub fn found(a: &[i8; 3], b: &[i8; 2], x: i8) -> Option<i8> {
    a.iter().chain(b).map(|value| 100 / *value).find(|value| *value == x)
}

/// Chains with a step: of lists, from the end, and zipped with another.
#[function]
pub fn steps(values: &List<i32, 7>, other: &[i32; 3]) -> [i32; 3] {
    let mut sums = [0; 3];
    for x in values.iter().step_by(3) {
        sums[0] = sums[0] % 100 * 3 + x % 7;
    }
    for x in values.iter().step_by(3).rev() {
        sums[1] = sums[1] % 100 * 3 + x % 7;
    }
    for (x, y) in values.iter().rev().step_by(2).zip(other) {
        sums[2] = sums[2] % 100 * 3 + x % 7 - y % 5;
    }
    sums
}

/// Writes every second or third element of a chain.
#[function]
pub fn written(values: &mut [i32; 5], by: i32) {
    for value in values.iter_mut().step_by(2) {
        *value = value.wrapping_add(by);
    }
}

/// Chained ranges whose ends are at the limits of their types.
#[function]
pub fn limits(from: u8, to: u8) -> (u32, u32) {
    let mut sums = (0, 0);
    for x in (from..=to).step_by(7) {
        sums.0 += u32::from(x);
    }
    for x in (from..=to).step_by(2).rev() {
        sums.1 = sums.1 % 1000 * 2 + u32::from(x);
    }
    sums
}
