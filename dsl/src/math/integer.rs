//! Powers of integers, and saturating and wrapping operations that the IR lacks.
//!
//! Powers are computed by squaring, with a factor for each bit of the exponent. If the result fits, so do all
//! intermediate products, so these functions fault exactly where Rust's do.

use crate::prelude::*;

macro_rules! magnitudes {
    ($($int:ident $neg:ident $abs:ident;)*) => {$(
        /// `-a`, or the largest value if that overflows.
        #[function(expand)]
        pub fn $neg(a: $int) -> $int {
            $int::saturating_sub(0, a)
        }

        /// The magnitude, or the largest value if that overflows.
        #[function(expand)]
        pub fn $abs(a: $int) -> $int {
            if a < 0 { $int::saturating_sub(0, a) } else { a }
        }
    )*};
}

magnitudes! {
    i8 neg_i8 abs_i8;
    i16 neg_i16 abs_i16;
    i32 neg_i32 abs_i32;
    i64 neg_i64 abs_i64;
    isize neg_isize abs_isize;
}

macro_rules! with_signed {
    ($($int:ident $signed:ident $saturating:ident $wrapping:ident;)*) => {$(
        /// `a + b` for a signed `b`, or the nearest value of the type.
        #[function]
        pub fn $saturating(a: $int, b: $signed) -> $int {
            if b < 0 { a.saturating_sub(b.unsigned_abs()) } else { a.saturating_add(b.unsigned_abs()) }
        }

        /// `a + b` for a signed `b`, wrapped to the type's width.
        #[function(expand)]
        pub fn $wrapping(a: $int, b: $signed) -> $int {
            a.wrapping_add(b as $int)
        }
    )*};
}

with_signed! {
    u8 i8 saturating_add_signed_u8 wrapping_add_signed_u8;
    u16 i16 saturating_add_signed_u16 wrapping_add_signed_u16;
    u32 i32 saturating_add_signed_u32 wrapping_add_signed_u32;
    u64 i64 saturating_add_signed_u64 wrapping_add_signed_u64;
    usize isize saturating_add_signed_usize wrapping_add_signed_usize;
}

macro_rules! powers {
    ($($int:ident, $pow:ident, $wrapping_pow:ident;)*) => {$(
        /// `base` to the power of `exponent`.
        #[function]
        pub fn $pow(base: $int, exponent: u32) -> $int {
            let mut result: $int = 1;
            let mut square = base;
            let mut left = exponent;
            for _ in 0..32 {
                if left & 1 == 1 {
                    result *= square;
                }
                left >>= 1;
                if left == 0 {
                    break;
                }
                square *= square;
            }
            result
        }

        /// `base` to the power of `exponent`, wrapped to the type's width.
        #[function]
        pub fn $wrapping_pow(base: $int, exponent: u32) -> $int {
            let mut result: $int = 1;
            let mut square = base;
            let mut left = exponent;
            for _ in 0..32 {
                if left & 1 == 1 {
                    result = result.wrapping_mul(square);
                }
                left >>= 1;
                if left == 0 {
                    break;
                }
                square = square.wrapping_mul(square);
            }
            result
        }
    )*};
}

powers! {
    i8, pow_i8, wrapping_pow_i8;
    i16, pow_i16, wrapping_pow_i16;
    i32, pow_i32, wrapping_pow_i32;
    i64, pow_i64, wrapping_pow_i64;
    isize, pow_isize, wrapping_pow_isize;
    u8, pow_u8, wrapping_pow_u8;
    u16, pow_u16, wrapping_pow_u16;
    u32, pow_u32, wrapping_pow_u32;
    u64, pow_u64, wrapping_pow_u64;
    usize, pow_usize, wrapping_pow_usize;
}
