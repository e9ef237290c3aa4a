//! Rotations and turned bytes.

use bessemer::prelude::*;

/// A step of a hash.
#[function]
pub fn mixed(hash: u32, word: u32) -> u32 {
    (hash.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9)
}

/// The bytes of a word from the other kind of machine.
#[function]
pub fn turned(word: u32) -> u32 {
    word.swap_bytes()
}
