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
    ([$int:ident $($more:ident)*] {$($companion:ident($($operand:ident),*): $function:ident -> $result:ty;)*}) => {
        impl WholeBuiltins for $int {$(
            fn $companion(self $(, $operand: $int)*) -> told!([] $result) {
                whole::$function::__call(self $(, $operand)*)
            }
        )*}
        implement! { [$($more)*] {$($companion($($operand),*): $function -> $result;)*} }
    };
}

macro_rules! companions {
    ($($companion:ident($($operand:ident),*): $function:ident -> $result:ty;)*) => {
        /// Methods of integers.
        pub trait WholeBuiltins: Sized {$(
            fn $companion(self $(, $operand: Self)*) -> told!([Self] $result);
        )*}

        implement! {
            [i8 i16 i32 i64 isize u8 u16 u32 u64 usize]
            {$($companion($($operand),*): $function -> $result;)*}
        }
    };
}

companions! {
    __b_div_ceil(by): div_ceil -> Self;
    __b_next_multiple_of(of): next_multiple_of -> Self;
    __b_is_multiple_of(of): is_multiple_of -> bool;
    __b_next_power_of_two(): next_power_of_two -> Self;
    __b_checked_next_power_of_two(): checked_next_power_of_two -> Option<Self>;
    __b_ilog2(): ilog2 -> u32;
    __b_checked_ilog2(): checked_ilog2 -> Option<u32>;
    __b_isqrt(): isqrt -> Self;
    __b_midpoint(other): midpoint -> Self;
    __b_reverse_bits(): reverse_bits -> Self;
    __b_overflowing_add(other): overflowing_add -> (Self, bool);
    __b_overflowing_sub(other): overflowing_sub -> (Self, bool);
    __b_overflowing_mul(other): overflowing_mul -> (Self, bool);
}
