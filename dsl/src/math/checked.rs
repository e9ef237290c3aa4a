//! Checked arithmetic of integers: `None` if the result does not fit into its type.
//!
//! No operation here can fault: each condition for a fault is tested first.

use crate::prelude::*;

macro_rules! both {
    ($int:ident: $mul:ident $shl:ident $shr:ident $pow:ident) => {
        /// `a << bits`; `None` if `bits` is not below the width.
        #[function]
        pub fn $shl(a: $int, bits: u32) -> Option<$int> {
            if bits < $int::BITS { Some(a << bits) } else { None }
        }

        /// `a >> bits`; `None` if `bits` is not below the width.
        #[function]
        pub fn $shr(a: $int, bits: u32) -> Option<$int> {
            if bits < $int::BITS { Some(a >> bits) } else { None }
        }

        /// `base` to the power of `exponent`, by squaring.
        #[function]
        pub fn $pow(base: $int, exponent: u32) -> Option<$int> {
            let mut result: $int = 1;
            let mut square = base;
            let mut left = exponent;
            for _ in 0..32 {
                if left & 1 == 1 {
                    result = $mul(result, square)?;
                }
                left >>= 1;
                if left == 0 {
                    break;
                }
                square = $mul(square, square)?;
            }
            Some(result)
        }
    };
}

macro_rules! signed {
    ($($int:ident: $add:ident $sub:ident $mul:ident $div:ident $rem:ident $neg:ident $abs:ident $shl:ident $shr:ident $pow:ident;)*) => {$(
        /// `a + b`.
        #[function]
        pub fn $add(a: $int, b: $int) -> Option<$int> {
            let sum = a.wrapping_add(b);
            if (b < 0) == (sum < a) { Some(sum) } else { None }
        }

        /// `a - b`.
        #[function]
        pub fn $sub(a: $int, b: $int) -> Option<$int> {
            let difference = a.wrapping_sub(b);
            if (b > 0) == (difference < a) { Some(difference) } else { None }
        }

        /// `a / b`; `None` for a divisor of 0 or an overflow.
        #[function]
        pub fn $div(a: $int, b: $int) -> Option<$int> {
            if b > 0 {
                return Some(a.wrapping_div(b));
            }
            if b < -1 {
                return Some(a.wrapping_div(b));
            }
            if b == -1 && a > $int::MIN { Some(-a) } else { None }
        }

        /// `a % b`; `None` for a divisor of 0 or an overflow of the quotient.
        #[function]
        pub fn $rem(a: $int, b: $int) -> Option<$int> {
            if b > 0 {
                return Some(a.wrapping_rem(b));
            }
            if b < -1 {
                return Some(a.wrapping_rem(b));
            }
            if b == -1 && a > $int::MIN { Some(0) } else { None }
        }

        /// `-a`.
        #[function]
        pub fn $neg(a: $int) -> Option<$int> {
            if a > $int::MIN { Some(-a) } else { None }
        }

        /// `|a|`.
        #[function]
        pub fn $abs(a: $int) -> Option<$int> {
            if a > $int::MIN { Some(a.abs()) } else { None }
        }

        both! { $int: $mul $shl $shr $pow }
    )*};
}

macro_rules! unsigned {
    ($($int:ident $signed:ident: $add:ident $sub:ident $mul:ident $div:ident $rem:ident $neg:ident $shl:ident $shr:ident $pow:ident $add_signed:ident;)*) => {$(
        /// `a + b` for a signed `b`.
        #[function]
        pub fn $add_signed(a: $int, b: $signed) -> Option<$int> {
            let sum = a.wrapping_add(b as $int);
            if (b < 0) == (sum < a) { Some(sum) } else { None }
        }

        /// `a + b`.
        #[function]
        pub fn $add(a: $int, b: $int) -> Option<$int> {
            let sum = a.wrapping_add(b);
            if sum >= a { Some(sum) } else { None }
        }

        /// `a - b`.
        #[function]
        pub fn $sub(a: $int, b: $int) -> Option<$int> {
            if a >= b { Some(a.wrapping_sub(b)) } else { None }
        }

        /// `a / b`; `None` for a divisor of 0.
        #[function]
        pub fn $div(a: $int, b: $int) -> Option<$int> {
            if b > 0 { Some(a / b) } else { None }
        }

        /// `a % b`; `None` for a divisor of 0.
        #[function]
        pub fn $rem(a: $int, b: $int) -> Option<$int> {
            if b > 0 { Some(a % b) } else { None }
        }

        /// `-a` of an unsigned integer: `None` unless it is 0.
        #[function]
        pub fn $neg(a: $int) -> Option<$int> {
            if a == 0 { Some(0) } else { None }
        }

        both! { $int: $mul $shl $shr $pow }
    )*};
}

macro_rules! narrow_products {
    ($($int:ident $wide:ident $mul:ident;)*) => {$(
        /// `a * b`, computed in a wider type.
        #[function]
        pub fn $mul(a: $int, b: $int) -> Option<$int> {
            let wide = (a as $wide).wrapping_mul(b as $wide);
            let product = wide as $int;
            if product as $wide == wide { Some(product) } else { None }
        }
    )*};
}

macro_rules! wide_products {
    ($($signed:ident $unsigned:ident $mul_signed:ident $mul_unsigned:ident;)*) => {$(
        /// `a * b`.
        #[function]
        pub fn $mul_unsigned(a: $unsigned, b: $unsigned) -> Option<$unsigned> {
            if a > 0 && b > $unsigned::MAX / a { None } else { Some(a.wrapping_mul(b)) }
        }

        /// `a * b`, computed from the magnitudes.
        #[function]
        pub fn $mul_signed(a: $signed, b: $signed) -> Option<$signed> {
            let magnitude = $mul_unsigned(a.unsigned_abs(), b.unsigned_abs())?;
            let negative = (a < 0) != (b < 0);
            let most = if negative { $signed::MIN.unsigned_abs() } else { $signed::MAX as $unsigned };
            if magnitude > most {
                return None;
            }
            let product = magnitude as $signed;
            Some(if negative { product.wrapping_neg() } else { product })
        }
    )*};
}

signed! {
    i8: add_i8 sub_i8 mul_i8 div_i8 rem_i8 neg_i8 abs_i8 shl_i8 shr_i8 pow_i8;
    i16: add_i16 sub_i16 mul_i16 div_i16 rem_i16 neg_i16 abs_i16 shl_i16 shr_i16 pow_i16;
    i32: add_i32 sub_i32 mul_i32 div_i32 rem_i32 neg_i32 abs_i32 shl_i32 shr_i32 pow_i32;
    i64: add_i64 sub_i64 mul_i64 div_i64 rem_i64 neg_i64 abs_i64 shl_i64 shr_i64 pow_i64;
    isize: add_isize sub_isize mul_isize div_isize rem_isize neg_isize abs_isize shl_isize shr_isize pow_isize;
}

unsigned! {
    u8 i8: add_u8 sub_u8 mul_u8 div_u8 rem_u8 neg_u8 shl_u8 shr_u8 pow_u8 add_signed_u8;
    u16 i16: add_u16 sub_u16 mul_u16 div_u16 rem_u16 neg_u16 shl_u16 shr_u16 pow_u16 add_signed_u16;
    u32 i32: add_u32 sub_u32 mul_u32 div_u32 rem_u32 neg_u32 shl_u32 shr_u32 pow_u32 add_signed_u32;
    u64 i64: add_u64 sub_u64 mul_u64 div_u64 rem_u64 neg_u64 shl_u64 shr_u64 pow_u64 add_signed_u64;
    usize isize: add_usize sub_usize mul_usize div_usize rem_usize neg_usize shl_usize shr_usize pow_usize add_signed_usize;
}

narrow_products! {
    i8 i64 mul_i8;
    i16 i64 mul_i16;
    i32 i64 mul_i32;
    u8 u64 mul_u8;
    u16 u64 mul_u16;
    u32 u64 mul_u32;
}

wide_products! {
    i64 u64 mul_i64 mul_u64;
    isize usize mul_isize mul_usize;
}
