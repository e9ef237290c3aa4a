//! The companions of methods of integers that are functions of [`math::whole`](crate::math::whole).

#![allow(missing_docs)]

use super::builder::Callee;
use super::slot::Called;
use crate::math::whole;

/// What such a companion returns.
macro_rules! told {
    ([$($kept:ident)?] $result:ty) => { Called<impl Callee + use<$($kept)?>, $result> };
}

/// Of each type by itself: where a bound would stand, rustc would tell of it.
macro_rules! implement {
    ([] $companions:tt) => {};
    ([$int:ident $($more:ident)*] {$($companion:ident($($operand:ident: $ty:ident),*): $function:ident -> $result:ty;)*}) => {
        impl WholeBuiltins for $int {$(
            fn $companion(self $(, $operand: $ty)*) -> told!([] $result) {
                whole::$function::__call(self $(, $operand)*)
            }
        )*}
        implement! { [$($more)*] {$($companion($($operand: $ty),*): $function -> $result;)*} }
    };
}

macro_rules! companions {
    ($($companion:ident($($operand:ident: $ty:ident),*): $function:ident -> $result:ty;)*) => {
        /// Methods of integers.
        pub trait WholeBuiltins: Sized {$(
            fn $companion(self $(, $operand: $ty)*) -> told!([Self] $result);
        )*}

        implement! {
            [i8 i16 i32 i64 isize u8 u16 u32 u64 usize]
            {$($companion($($operand: $ty),*): $function -> $result;)*}
        }
    };
}

companions! {
    __b_div_ceil(by: Self): div_ceil -> Self;
    __b_next_multiple_of(of: Self): next_multiple_of -> Self;
    __b_is_multiple_of(of: Self): is_multiple_of -> bool;
    __b_next_power_of_two(): next_power_of_two -> Self;
    __b_checked_next_power_of_two(): checked_next_power_of_two -> Option<Self>;
    __b_ilog2(): ilog2 -> u32;
    __b_checked_ilog2(): checked_ilog2 -> Option<u32>;
    __b_isqrt(): isqrt -> Self;
    __b_midpoint(other: Self): midpoint -> Self;
    __b_reverse_bits(): reverse_bits -> Self;
    __b_overflowing_add(other: Self): overflowing_add -> (Self, bool);
    __b_overflowing_sub(other: Self): overflowing_sub -> (Self, bool);
    __b_overflowing_mul(other: Self): overflowing_mul -> (Self, bool);
    __b_overflowing_neg(): overflowing_neg -> (Self, bool);
    __b_saturating_div(by: Self): saturating_div -> Self;
    __b_saturating_pow(exponent: u32): saturating_pow -> Self;
    __b_checked_div_euclid(by: Self): checked_div_euclid -> Option<Self>;
    __b_checked_rem_euclid(by: Self): checked_rem_euclid -> Option<Self>;
    __b_checked_next_multiple_of(of: Self): checked_next_multiple_of -> Option<Self>;
    __b_checked_isqrt(): checked_isqrt -> Option<Self>;
    __b_ilog10(): ilog10 -> u32;
    __b_checked_ilog10(): checked_ilog10 -> Option<u32>;
    __b_unbounded_shl(bits: u32): unbounded_shl -> Self;
    __b_unbounded_shr(bits: u32): unbounded_shr -> Self;
}
