//! Patterns that are longer or shorter than a slice with constant bounds; rustc knows the length of an array, but not
//! of a slice.

use bessemer::prelude::*;

/// An arm that reaches beyond the end of a slice of one element.
#[function]
pub fn beyond(rows: &[[i16; 4]; 2], row: u8) -> i16 {
    match &rows[usize::from(row) % 2][3..] {
        [x, y, ..] => x ^ y,
        [x] => *x,
        [] => 7,
    }
}

/// Arms that are too short and too long before the one that fits.
#[function]
pub fn fitting(values: &[i16; 4]) -> i16 {
    match &values[..2] {
        [x] => *x,
        [x, y, z, ..] => x ^ y ^ z,
        [x, rest @ ..] => x ^ rest[0] ^ 1,
        [] => 3,
    }
}

/// An `if let` whose pattern is longer than its slice.
#[function]
pub fn longer(values: &[i16; 4]) -> i16 {
    if let [x, y, .., z] = &values[2..] {
        return x ^ y ^ z;
    }
    values[0]
}

/// A `let … else` whose pattern is longer than its slice.
#[function]
pub fn otherwise(values: &[i16; 4]) -> i16 {
    let [x, _, y] = &values[1..3] else { return values[3] };
    x ^ y
}

/// Patterns on a named slice.
#[function]
pub fn named(values: &[i16; 4]) -> i16 {
    let part = &values[1..2];
    let mut found = 1;
    if let [x, y] = part {
        found = x ^ y;
    }
    if let [.., last] = part {
        found ^= *last;
    }
    if matches!(part, [_, _, ..]) { 0 } else { found }
}

/// Header and payload of a frame.
#[function]
pub fn frame(bytes: &[u8; 8]) -> u16 {
    let [low, high] = &bytes[2..4] else { return 0 };
    if let [a, .., b] = &bytes[4..] {
        return u16::from(*a) ^ u16::from(*b) ^ u16::from(*low);
    }
    match (&bytes[..2], bytes[7]) {
        ([1, x], 3) => u16::from(*x),
        ([_, _, _], 4) => 7,
        _ => u16::from(*high),
    }
}
