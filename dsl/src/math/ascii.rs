//! Classification and conversion of bytes and characters; a character is its code point, a `u32`.

use crate::prelude::*;

/// Returns true for `0` to `9`.
#[function]
pub fn is_digit(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9')
}

/// Returns true for `0` to `9`, `A` to `F` and `a` to `f`.
#[function]
pub fn is_hexdigit(byte: u8) -> bool {
    is_digit(byte) || matches!(byte, b'A'..=b'F' | b'a'..=b'f')
}

/// Returns true for `A` to `Z`.
#[function]
pub fn is_uppercase(byte: u8) -> bool {
    matches!(byte, b'A'..=b'Z')
}

/// Returns true for `a` to `z`.
#[function]
pub fn is_lowercase(byte: u8) -> bool {
    matches!(byte, b'a'..=b'z')
}

/// Returns true for `A` to `Z` and `a` to `z`.
#[function]
pub fn is_alphabetic(byte: u8) -> bool {
    is_uppercase(byte) || is_lowercase(byte)
}

/// Returns true for letters and digits of ASCII.
#[function]
pub fn is_alphanumeric(byte: u8) -> bool {
    is_alphabetic(byte) || is_digit(byte)
}

/// Returns true for a space, a tab, a line feed, a form feed and a carriage return.
#[function]
pub fn is_whitespace(byte: u8) -> bool {
    byte == 32 || byte == 9 || byte == 10 || byte == 12 || byte == 13
}

/// The upper-case letter of a lower-case letter of ASCII; any other byte unchanged.
#[function]
pub fn to_uppercase(byte: u8) -> u8 {
    if is_lowercase(byte) { byte - 32 } else { byte }
}

/// The lower-case letter of an upper-case letter of ASCII; any other byte unchanged.
#[function]
pub fn to_lowercase(byte: u8) -> u8 {
    if is_uppercase(byte) { byte + 32 } else { byte }
}

/// The character with a code point; `None` for a surrogate and for a number above U+10FFFF.
#[function]
pub fn from_code(code: u32) -> Option<u32> {
    if code < 0xd800 || (code > 0xdfff && code <= 0x0010_ffff) { Some(code) } else { None }
}

/// The value of a digit or letter in a base from 2 to 36; `None` for any other character.
#[function]
pub fn to_digit(code: u32, base: u32) -> Option<u32> {
    assert!((2..=36).contains(&base));
    let value = match code {
        0x30..=0x39 => code - 0x30,
        0x41..=0x5a => code - 0x41 + 10,
        0x61..=0x7a => code - 0x61 + 10,
        _ => base,
    };
    if value < base { Some(value) } else { None }
}

/// Returns true if a character is a digit or letter of a base from 2 to 36.
#[function]
pub fn is_digit_of(code: u32, base: u32) -> bool {
    to_digit(code, base).is_some()
}

/// Returns true if a code point is below 128.
#[function(expand)]
pub fn is_ascii(code: u32) -> bool {
    code < 128
}

/// The digit or lower-case letter for a value in a base up to 36; `None` if the value is not below the base.
#[function]
pub fn from_digit(value: u32, base: u32) -> Option<u32> {
    assert!(base <= 36);
    if value >= base {
        return None;
    }
    Some(if value < 10 { 0x30 + value } else { 0x61 - 10 + value })
}

macro_rules! characters {
    ($($function:ident: $of_byte:ident;)*) => {$(
        /// Tests a character.
        #[function]
        pub fn $function(code: u32) -> bool {
            code < 128 && $of_byte(code as u8)
        }
    )*};
}

characters! {
    char_is_digit: is_digit;
    char_is_hexdigit: is_hexdigit;
    char_is_uppercase: is_uppercase;
    char_is_lowercase: is_lowercase;
    char_is_alphabetic: is_alphabetic;
    char_is_alphanumeric: is_alphanumeric;
    char_is_whitespace: is_whitespace;
}

/// Upper case of a character.
#[function]
pub fn char_to_uppercase(code: u32) -> u32 {
    if char_is_lowercase(code) { code - 32 } else { code }
}

/// Lower case of a character.
#[function]
pub fn char_to_lowercase(code: u32) -> u32 {
    if char_is_uppercase(code) { code + 32 } else { code }
}
