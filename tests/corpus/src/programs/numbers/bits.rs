//! Bits are set, cleared, tested and counted as in Rust.

use bessemer::prelude::*;

/// Mask of the register's ready bit.
const READY: u8 = 1 << 7;
/// Mask of the register's channel bits.
const CHANNEL: u8 = 0b0000_0111;

/// The register's value with another channel and the ready bit cleared.
#[function]
pub fn with_channel(register: u8, channel: u8) -> u8 {
    (register & !(CHANNEL | READY)) | (channel & CHANNEL)
}

/// Returns true if one number of a wrapping sequence is ahead of another, by less than half of its range. The C keeps
/// the author's base.
#[function]
pub fn is_ahead(one: u16, other: u16) -> bool {
    let ahead = one.wrapping_sub(other);
    ahead > 0 && ahead < 0x8000
}

/// Returns true if the number of set bits is odd.
#[function]
pub fn parity(word: u32) -> bool {
    word.count_ones() % 2 == 1
}

/// The index of the highest bit that is set, or 32.
#[function]
pub fn highest(word: u32) -> u32 {
    if word == 0 { 32 } else { 31 - word.leading_zeros() }
}
