//! Ranges without an end, alone and zipped with elements. The request after the last number of the type is a fault,
//! and a `zip` requests from its parts in order, one time more often than the shortest has elements.

use bessemer::prelude::*;

/// The range is requested from before the elements end, so it may fault.
#[function]
pub fn range_first(n: u8, values: &[u8; 3]) -> u32 {
    let mut sum = 0;
    for (i, x) in (250 + n % 6..).zip(values) {
        if *x == 0 {
            continue;
        }
        sum += u32::from(i) * u32::from(*x);
    }
    sum
}

/// The elements end first, so the range is not requested from again.
#[function]
pub fn elements_first(n: u8, values: &[u8; 3]) -> u32 {
    let mut sum = 0;
    for (x, i) in values.iter().zip(250 + n % 6..) {
        sum += u32::from(i) * u32::from(*x);
    }
    sum
}

/// Three parts: whether the range is requested from once more depends on the second part's end.
#[function]
pub fn between(n: u8, values: &[u8; 4], a: usize, b: usize) -> u32 {
    let (first, second) = (&values[..a % 5], &values[..b % 5]);
    let mut sum = 0;
    for ((x, i), y) in first.iter().zip(250 + n % 6..).zip(second) {
        sum = sum * 2 + u32::from(i) + u32::from(*x ^ *y);
    }
    sum
}

/// Two ranges, one of them in the middle.
#[function]
pub fn two(n: i8, values: &[u8; 4], a: usize) -> i32 {
    let mut sum = 0;
    for (x, (i, (mut k, y))) in values[..a % 5].iter().zip((122 + n % 6..).zip((-3_i16..).zip(values))) {
        k *= 2;
        sum = sum * 2 + i32::from(i) * i32::from(k) + i32::from(*x & *y);
    }
    sum
}

/// After a `break`, no part is requested from.
#[function]
pub fn left(n: u8, values: &[u8; 3], most: u8) -> u8 {
    let mut seen = 0;
    for (i, x) in (250 + n % 6..).zip(values) {
        seen ^= i;
        if *x > most {
            break;
        }
    }
    seen
}

/// A zip with an empty slice.
#[function]
pub fn nothing(n: u8, values: &[u8; 3], a: usize) -> u8 {
    let mut seen = 0;
    for (i, x) in (250 + n % 6..).zip(&values[..a % 2]) {
        seen ^= i ^ x;
    }
    seen
}

/// Ranges that end before the last number of their type.
#[function]
pub fn calm(values: &mut [i16; 4]) -> (i16, usize, i16, Option<u8>) {
    let mut sum = 0;
    for (i, x) in (0..).zip(values.iter()) {
        sum ^= i ^ usize::from(*x > 0);
    }
    for (x, i) in values.iter_mut().zip(-2..) {
        *x ^= i;
    }
    let folded = (1..).zip(values.iter()).map(|(i, x)| i & x).fold(0, |a, b| a ^ b);
    let mut k = 0;
    for (n, (x, i)) in values.iter().zip(7_i16..).enumerate().skip(1).take(2) {
        k ^= i ^ x ^ (n as i16);
    }
    let at = values.iter().zip(1_u8..).max_by_key(|(x, _)| **x).map(|(_, i)| i);
    (folded, sum, k, at)
}

/// A zip with a range, advanced by `next`.
#[function]
pub fn by_hand(values: &[u8; 4]) -> (Option<(u8, u8)>, u8) {
    let mut pairs = (250..).zip(values.iter().copied());
    let first = pairs.next();
    (first, pairs.fold(0, |a, (i, x)| a ^ i ^ x))
}

/// Elements first: one number is requested for each, in whatever way the items are consumed.
#[function]
pub fn chained(n: u8, values: &[u8; 3]) -> (u32, bool, u32) {
    let sum = values.iter().zip(250 + n % 6..).map(|(x, i)| u32::from(*x) + u32::from(i)).sum();
    let all = values.iter().zip(252 + n % 2..).all(|(x, i)| *x < i);
    let mut some = 0;
    for (x, i) in values.iter().zip(250 + n % 6..).take(2) {
        some += u32::from(*x ^ i);
    }
    (sum, all, some)
}

/// A function that returns a zip with a range.
#[function]
fn numbered(values: &[u8; 3]) -> impl Iterator<Item = (u8, u8)> {
    (1..).zip(values.iter().copied())
}

/// Iterates over the returned zip.
#[function]
pub fn given(values: &[u8; 3]) -> u8 {
    numbered(values).fold(0, |a, (i, x)| a ^ (i * (x & 7)))
}

/// A range in a loop that only a `break` ends.
#[function]
pub fn alone(n: u8, most: u32) -> u32 {
    let mut sum = 0;
    for i in 240 + n % 16.. {
        sum += u32::from(i);
        if sum > most % 2048 {
            return u32::from(i);
        }
    }
    sum
}

/// A range in a chain that ends when it finds an item.
#[function]
pub fn found(n: i8, part: i8) -> (Option<i8>, Option<u16>) {
    let found = (100 + n % 28..).find(|i| i % 16 == part % 16);
    (found, (0..).map(|i: u16| i * i).find(|i| *i > 300))
}
