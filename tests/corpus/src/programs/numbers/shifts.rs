//! A shift by the width of the type or more is a fault; a shift by a constant needs no check.

use bessemer::prelude::*;

/// A bit field of a word.
#[function]
pub fn field(word: u32, first: u32, width: u32) -> u32 {
    (word >> first) & ((1 << width) - 1)
}

/// The middle half of a word: constant shifts need no check.
#[function]
pub fn middle(word: u32) -> u16 {
    (word >> 8) as u16
}

/// A shift of a signed number keeps the sign.
#[function]
pub fn halved(n: i16) -> i16 {
    n >> 1
}
