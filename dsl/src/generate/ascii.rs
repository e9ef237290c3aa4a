//! The companions of what `u8` and `char` know of letters and digits.

#![allow(missing_docs)]

use super::builder::Callee;
use super::builtin::companions;
use super::slot::Called;
use crate::math::ascii;

macro_rules! letters {
    ($($kind:ident $companion:ident: $of_byte:ident $of_char:ident -> $result:ty;)*) => {
        companions! {
            /// Methods of bytes and of characters.
            pub trait ByteBuiltins: Sized {
                $(type $kind: Callee;)*
                $(fn $companion(&self) -> $result = [Self::$kind];)*
            }
        }
        impl ByteBuiltins for u8 {
            $(type $kind = ascii::$of_byte;)*
        }
        impl ByteBuiltins for char {
            $(type $kind = ascii::$of_char;)*
        }
    };
}

letters! {
    Digit __b_is_ascii_digit: is_digit char_is_digit -> bool;
    Hexdigit __b_is_ascii_hexdigit: is_hexdigit char_is_hexdigit -> bool;
    Uppercase __b_is_ascii_uppercase: is_uppercase char_is_uppercase -> bool;
    Lowercase __b_is_ascii_lowercase: is_lowercase char_is_lowercase -> bool;
    Alphabetic __b_is_ascii_alphabetic: is_alphabetic char_is_alphabetic -> bool;
    Alphanumeric __b_is_ascii_alphanumeric: is_alphanumeric char_is_alphanumeric -> bool;
    Whitespace __b_is_ascii_whitespace: is_whitespace char_is_whitespace -> bool;
    ToUppercase __b_to_ascii_uppercase: to_uppercase char_to_uppercase -> Self;
    ToLowercase __b_to_ascii_lowercase: to_lowercase char_to_lowercase -> Self;
}

companions! {
    /// Methods of characters, of which the functions take the code point.
    impl[] CharBuiltins for char {
        fn __b_is_ascii(&self) -> bool = [ascii::is_ascii];
        fn __b_is_digit(self, _base: u32) -> bool = [ascii::is_digit_of];
        fn __b_to_digit(self, _base: u32) -> Option<u32> = [ascii::to_digit];
        fn __b_from_digit(_value: u32, _base: u32) -> Option<Self> = [ascii::from_digit];
        fn __b_from_u32(_code: u32) -> Option<Self> = [ascii::from_code];
    }
}
