//! Patterns destructure arrays and slices: from the front,
//! from the end, and the rest as a slice, without a copy.

use bessemer::prelude::*;

/// Code of a command, and the sum of the bytes after it.
#[function]
pub fn decoded(bytes: &[u8; 6]) -> (u8, u32) {
    let [code, rest @ ..] = bytes;
    let mut sum = 0;
    for byte in rest {
        sum += u32::from(*byte);
    }
    (*code, sum)
}

/// The span of some values; `None` if there are none.
#[function]
fn span_of(values: &[f32]) -> Option<f32> {
    match values {
        [] => None,
        [_] => Some(0.0),
        [first, .., last] => Some(last - first),
    }
}

/// The span of the values before `end`.
#[function]
pub fn span(values: &[f32; 4], end: usize) -> Option<f32> {
    span_of(&values[..end])
}

/// The largest of some values.
#[function]
fn largest(values: &[i16]) -> i16 {
    if let [first, middle @ .., last] = values {
        let mut most = (*first).max(*last);
        for value in middle {
            most = most.max(*value);
        }
        return most;
    }
    values.first().copied().unwrap_or(0)
}

/// The largest of the values from `start` on.
#[function]
pub fn largest_from(values: &[i16; 5], start: usize) -> i16 {
    largest(&values[start..])
}

/// The values after the first, as an array.
#[function]
pub fn tail(values: [i32; 4]) -> [i32; 3] {
    let [_, rest @ ..] = values;
    rest
}
