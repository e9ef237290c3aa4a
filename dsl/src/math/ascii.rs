//! Letters and digits among bytes.

use crate::prelude::*;

/// `0` to `9`.
#[function]
pub fn is_digit(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9')
}

/// `0` to `9`, `A` to `F`, `a` to `f`.
#[function]
pub fn is_hexdigit(byte: u8) -> bool {
    is_digit(byte) || matches!(byte, b'A'..=b'F' | b'a'..=b'f')
}

/// `A` to `Z`.
#[function]
pub fn is_uppercase(byte: u8) -> bool {
    matches!(byte, b'A'..=b'Z')
}

/// `a` to `z`.
#[function]
pub fn is_lowercase(byte: u8) -> bool {
    matches!(byte, b'a'..=b'z')
}

/// A letter.
#[function]
pub fn is_alphabetic(byte: u8) -> bool {
    is_uppercase(byte) || is_lowercase(byte)
}

/// A letter or a digit.
#[function]
pub fn is_alphanumeric(byte: u8) -> bool {
    is_alphabetic(byte) || is_digit(byte)
}

/// A space, a tabulator, the end of a line or of a page.
#[function]
pub fn is_whitespace(byte: u8) -> bool {
    byte == 32 || byte == 9 || byte == 10 || byte == 12 || byte == 13
}

/// The large letter for a small one.
#[function]
pub fn to_uppercase(byte: u8) -> u8 {
    if is_lowercase(byte) { byte - 32 } else { byte }
}

/// The small letter for a large one.
#[function]
pub fn to_lowercase(byte: u8) -> u8 {
    if is_uppercase(byte) { byte + 32 } else { byte }
}
