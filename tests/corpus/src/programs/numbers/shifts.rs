//! A shift by as many bits as the type has, or more, is a fault; by a constant it costs nothing.

use bessemer::prelude::*;

/// A field of a word.
#[function]
pub fn field(word: u32, first: u32, width: u32) -> u32 {
    (word >> first) & ((1 << width) - 1)
}

/// The middle half: constants need no check.
#[function]
pub fn middle(word: u32) -> u16 {
    (word >> 8) as u16
}

/// Arithmetic on signed numbers.
#[function]
pub fn halved(n: i16) -> i16 {
    n >> 1
}
