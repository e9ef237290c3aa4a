//! Letters and digits among bytes.

use bessemer::prelude::*;

/// The value of a hexadecimal digit.
#[function]
pub fn digit(byte: u8) -> Option<u8> {
    if byte.is_ascii_digit() {
        Some(byte - b'0')
    } else if byte.is_ascii_hexdigit() {
        Some(byte.to_ascii_uppercase() - b'A' + 10)
    } else {
        None
    }
}

/// Class of a byte.
#[function]
pub fn kind(byte: u8) -> u8 {
    match byte {
        _ if byte.is_ascii_whitespace() => 0,
        _ if byte.is_ascii_lowercase() => 1,
        _ if byte.is_ascii_uppercase() => 2,
        _ if byte.is_ascii_alphanumeric() => 3,
        _ => byte.to_ascii_lowercase(),
    }
}
