//! Ranges in structs, tuples and arrays, and as parameters: loops and chains over them, their lengths, and slices by
//! them.

use core::ops::{Range, RangeInclusive};

use bessemer::prelude::*;

/// An interval of time in which something is switched on.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    hours: Range<u8>,
    signed: (u8, Range<i8>),
    closed: RangeInclusive<u16>,
}

/// Constructs a window from its ends.
#[function]
pub fn made(from: u8, to: u8) -> Window {
    Window { hours: from..to, signed: (from, -3..to as i8), closed: u16::from(from)..=u16::from(to) }
}

/// Iterates over the ranges, directly and by adapters.
#[function]
pub fn through(window: &Window) -> [u32; 5] {
    let mut sums = [0_u32; 5];
    for hour in window.hours.clone() {
        sums[0] = sums[0].wrapping_add(u32::from(hour));
    }
    for (i, step) in window.signed.1.clone().enumerate() {
        sums[1] = sums[1].wrapping_add(i as u32).wrapping_mul(31).wrapping_add(step as u32);
    }
    sums[2] = window.hours.clone().rev().fold(1, |sum, hour| sum ^ u32::from(hour).rotate_left(sum & 7));
    for (hour, other) in window.hours.clone().step_by(3).zip(window.signed.1.clone()) {
        sums[3] = sums[3].wrapping_mul(17).wrapping_add(u32::from(hour) ^ other as u32);
    }
    sums[4] = window.hours.clone().map(u32::from).filter(|hour| hour % 5 != 0).max().unwrap_or(999);
    sums
}

/// A range that includes its end.
#[function]
pub fn closed(window: &Window) -> u32 {
    let mut digest = 7_u32;
    for value in window.closed.clone().take(40) {
        digest = digest.rotate_left(3) ^ u32::from(value);
    }
    digest
}

/// Lengths of ranges of several integer types.
#[function]
pub fn lengths(window: &Window, low: i32, high: i32) -> [usize; 4] {
    let wide = Range { start: low, end: high };
    let words = Range { start: low as u32, end: high as u32 };
    [window.hours.len(), window.signed.1.len(), wide.len(), words.len()]
}

/// A loop over a copy of the range: changes of the range in its body have no effect.
#[function]
pub fn changed(mut part: core::ops::Range<u8>) -> (u32, u8) {
    let mut count = 0_u32;
    for i in part.clone() {
        part.end = part.end.wrapping_add(i);
        part.start = part.start.wrapping_add(1);
        count += 1;
    }
    (count, part.start ^ part.end)
}

/// Slices by a range.
#[function]
pub fn parts(values: &[u8; 9], part: core::ops::Range<usize>) -> u32 {
    let mut sum = 0_u32;
    for value in &values[part.clone()] {
        sum += u32::from(*value);
    }
    for one in [1..4, 2..9, 5..5] {
        sum = sum.wrapping_mul(3) ^ one.clone().map(|i: usize| u32::from(values[i])).sum::<u32>();
        sum ^= values[one].len() as u32;
    }
    sum
}
