//! The companions of what `u8` and `char` know of letters and digits.

#![allow(missing_docs)]

use super::builder::Callee;
use super::factored::{gives, held};
use super::slot::Called;
use crate::math::ascii;

/// The result of a companion that is a function of the DSL.
macro_rules! told {
    ([$($kept:ident)?] $result:ty) => { Called<impl Callee + use<$($kept)?>, $result> };
}

macro_rules! companions {
    ($($companion:ident: $of_byte:ident $of_char:ident -> $result:ty;)*) => {
        /// Methods of bytes and of characters.
        pub trait ByteBuiltins: Sized {$(
            fn $companion(&self) -> told!([Self] $result);
        )*}
        impl ByteBuiltins for u8 {$(
            fn $companion(&self) -> told!([] $result) {
                ascii::$of_byte::__call(*self)
            }
        )*}
        impl ByteBuiltins for char {$(
            fn $companion(&self) -> told!([] $result) {
                gives(ascii::$of_char::__call(*held(self)))
            }
        )*}
    };
}

companions! {
    __b_is_ascii_digit: is_digit char_is_digit -> bool;
    __b_is_ascii_hexdigit: is_hexdigit char_is_hexdigit -> bool;
    __b_is_ascii_uppercase: is_uppercase char_is_uppercase -> bool;
    __b_is_ascii_lowercase: is_lowercase char_is_lowercase -> bool;
    __b_is_ascii_alphabetic: is_alphabetic char_is_alphabetic -> bool;
    __b_is_ascii_alphanumeric: is_alphanumeric char_is_alphanumeric -> bool;
    __b_is_ascii_whitespace: is_whitespace char_is_whitespace -> bool;
    __b_to_ascii_uppercase: to_uppercase char_to_uppercase -> Self;
    __b_to_ascii_lowercase: to_lowercase char_to_lowercase -> Self;
}

/// Methods of characters, of which the functions take the code point.
pub trait CharBuiltins: Sized {
    fn __b_is_ascii(&self) -> told!([Self] bool);
    fn __b_is_digit(self, base: u32) -> told!([Self] bool);
    fn __b_to_digit(self, base: u32) -> told!([Self] Option<u32>);
    fn __b_from_digit(value: u32, base: u32) -> told!([Self] Option<Self>);
    fn __b_from_u32(code: u32) -> told!([Self] Option<Self>);
}

impl CharBuiltins for char {
    fn __b_is_ascii(&self) -> told!([] bool) {
        ascii::is_ascii::__call(*held(self))
    }
    fn __b_is_digit(self, base: u32) -> told!([] bool) {
        ascii::is_digit_of::__call(*held(&self), base)
    }
    fn __b_to_digit(self, base: u32) -> told!([] Option<u32>) {
        ascii::to_digit::__call(*held(&self), base)
    }
    fn __b_from_digit(value: u32, base: u32) -> told!([] Option<Self>) {
        gives(ascii::from_digit::__call(value, base))
    }
    fn __b_from_u32(code: u32) -> told!([] Option<Self>) {
        gives(ascii::from_code::__call(code))
    }
}
