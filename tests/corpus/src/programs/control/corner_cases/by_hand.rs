//! Iterators that are advanced by `next` calls: each call continues where the previous one stopped.

use bessemer::prelude::*;

/// The bytes after a length byte, or `None` if some are missing.
#[function]
pub fn behind_a_length(frame: &[u8; 6]) -> Option<u32> {
    let mut bytes = frame.iter().copied();
    let length = bytes.next()?;
    let mut sum = u32::from(length);
    for _ in 0..length {
        sum = sum.wrapping_mul(3) ^ u32::from(bytes.next()?);
    }
    Some(sum)
}

/// Takes two items with `next`, and then iterates over the rest.
#[function]
pub fn first_and_rest(values: &[i32; 5]) -> i32 {
    let mut left = values.iter();
    let first = left.next().copied().unwrap_or(1);
    let second = left.next().copied().unwrap_or(2);
    let mut joined = first.wrapping_sub(second);
    while let Some(value) = left.next() {
        joined = joined.wrapping_mul(3) ^ value;
    }
    joined
}

/// The items that remain after methods that stop early, and after copies, which consume nothing of the original.
#[function]
pub fn left_by_ends(values: &[i32; 7], key: i32) -> i32 {
    let mut left = values.iter().map(|value| value ^ key).filter(|value| *value > 0);
    let first = left.next();
    let large = left.find(|value| *value > 100);
    let count = left.clone().count() as i32;
    let skipped = left.position(|value| value > 50).map_or(9, |at| at as i32);
    let any = left.any(|value| value > 20);
    let next = left.nth(1).unwrap_or(3);
    let joined = first.unwrap_or(1).wrapping_mul(7) ^ large.unwrap_or(2).wrapping_mul(11);
    let rest = left.fold(next, |so_far, value| so_far.wrapping_mul(5) ^ value);
    joined ^ skipped ^ rest.wrapping_mul(count) ^ i32::from(any)
}

/// Several loops over one iterator, and the enumerated items of the last.
#[function]
pub fn loops_in_turn(one: &[u8; 6], other: &[u8; 6]) -> u32 {
    let mut pairs = one.iter().zip(other.iter());
    let mut joined = 0_u32;
    for (x, y) in pairs.by_ref() {
        joined = joined.wrapping_mul(5) ^ u32::from(*x);
        if x > y {
            break;
        }
    }
    for (x, y) in &mut pairs {
        joined = joined.wrapping_mul(7) ^ u32::from(*y);
        if x < y {
            break;
        }
    }
    for (i, (x, _)) in pairs.enumerate() {
        joined = joined.wrapping_mul(9) ^ u32::from(*x) ^ i as u32;
    }
    joined
}

/// Every second item, as long as the items increase.
#[function]
pub fn growing(values: &[u8; 8]) -> usize {
    let mut numbered = values.iter().enumerate().take(7);
    let mut last = 0;
    #[bound(8)]
    while let Some((i, value)) = numbered.next() {
        if *value < last {
            return i;
        }
        last = *value;
        numbered.next();
    }
    values.len()
}

/// A loop that advances its own iterator and stops.
#[function]
pub fn words(bytes: &[u8; 8], ends: u8) -> [u32; 3] {
    let mut left = bytes.chunks(3);
    let mut words = [0; 3];
    for word in &mut words {
        let Some(part) = left.next() else { break };
        for byte in part {
            *word = *word << 8 | u32::from(*byte);
        }
        if part[0] == ends {
            left.next();
        }
    }
    words
}

/// Advances an iterator parameter by `next`, and counts the rest.
#[function]
fn two_and_count(mut items: impl Iterator<Item = u8>) -> u32 {
    let first = items.next().unwrap_or(1);
    let second = items.next().unwrap_or(2);
    u32::from(first) * 3 + u32::from(second) + items.count() as u32
}

/// Chained and filtered items of two other iterators, advanced by `next`.
#[function]
pub fn of_two(bytes: &[u8; 4], other: &[u8], most: u8) -> u32 {
    let behind = two_and_count(other.iter().copied().filter(|byte| *byte <= most));
    two_and_count(bytes.iter().map(|byte| byte / 2)) ^ behind
}

/// Clones of an iterator, which advance independently of it.
#[function]
pub fn copies(values: &[u8; 6]) -> u32 {
    let mut left = values.iter().copied();
    let first = left.next().unwrap_or(1);
    let rest = left.clone();
    let mut ahead = left.clone();
    let second = left.next().unwrap_or(2);
    let both = ahead.next().unwrap_or(3) ^ ahead.next().unwrap_or(4);
    let joined = rest.fold(u32::from(first), |so_far, value| so_far * 3 ^ u32::from(value));
    let third = left.next().unwrap_or(5);
    joined
        ^ u32::from(second) << 8
        ^ u32::from(both) << 16
        ^ u32::from(third) << 24
        ^ ahead.count() as u32
}
