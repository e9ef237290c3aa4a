//! Base64 of three bytes, as a telemetry link over text needs it.

use bessemer::prelude::*;

/// The 64 digits, in the order of their values.
const DIGITS: [u8; 64] = *b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Encodes up to three bytes as four characters.
#[function]
pub fn letters(bytes: [u8; 3], count: u8) -> [u8; 4] {
    let word = u32::from(bytes[0]) << 16 | u32::from(bytes[1]) << 8 | u32::from(bytes[2]);
    let mut letters = [b'='; 4];
    for (i, letter) in letters.iter_mut().enumerate() {
        if i <= usize::from(count) {
            *letter = DIGITS[(word >> (18 - 6 * i)) as usize & 63];
        }
    }
    letters
}
