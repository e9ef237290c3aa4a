//! The companions of what `u8` knows of letters and digits.

#![allow(missing_docs)]

use super::builder::Callee;
use super::slot::Called;
use crate::math::ascii;

/// The result of a companion that is a function of the DSL.
macro_rules! told {
    ([$($kept:ident)?] $result:ty) => { Called<impl Callee + use<$($kept)?>, $result> };
}

macro_rules! bytes {
    ($($companion:ident: $function:ident -> $result:ty;)*) => {
        /// Methods of bytes.
        pub trait ByteBuiltins: Sized {$(
            fn $companion(&self) -> told!([Self] $result);
        )*}
        impl ByteBuiltins for u8 {$(
            fn $companion(&self) -> told!([] $result) {
                ascii::$function::__call(*self)
            }
        )*}
    };
}

bytes! {
    __b_is_ascii_digit: is_digit -> bool;
    __b_is_ascii_hexdigit: is_hexdigit -> bool;
    __b_is_ascii_uppercase: is_uppercase -> bool;
    __b_is_ascii_lowercase: is_lowercase -> bool;
    __b_is_ascii_alphabetic: is_alphabetic -> bool;
    __b_is_ascii_alphanumeric: is_alphanumeric -> bool;
    __b_is_ascii_whitespace: is_whitespace -> bool;
    __b_to_ascii_uppercase: to_uppercase -> u8;
    __b_to_ascii_lowercase: to_lowercase -> u8;
}
