//! Slices are equal if their lengths and elements are; an array is compared as a slice.

use bessemer::prelude::*;

/// Returns true if the halves of eight bytes are equal, and also the parts before and after an index.
#[function]
pub fn halves(bytes: [u8; 8], n: usize) -> bool {
    let left = &bytes[..4];
    let right = &bytes[4..];
    left == right || bytes[..n] == bytes[n..]
}

/// Returns true if a part equals another; a NaN is unequal to everything.
#[function]
pub fn parts(x: [f64; 4], i: usize) -> bool {
    x[i..] == x[..2] || x[1..3] != x[2..4]
}

#[function]
fn begins_with(text: &[u8], start: &[u8]) -> bool {
    text.len() >= start.len() && &text[..start.len()] == start
}

/// Returns true if a line begins like a position sentence.
#[function]
pub fn is_position(line: [u8; 5]) -> bool {
    begins_with(&line, b"GP") && line[2..] == *b"GGA"
}
