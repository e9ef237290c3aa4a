//! Rotations of bits, and reversed bytes.

use bessemer::prelude::*;

/// A step of a hash.
#[function]
pub fn mixed(hash: u32, word: u32) -> u32 {
    (hash.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9)
}

/// A word with the other byte order.
#[function]
pub fn turned(word: u32) -> u32 {
    word.swap_bytes()
}
