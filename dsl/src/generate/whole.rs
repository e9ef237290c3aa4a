//! The companions of methods of integers that are functions of [`math::whole`](crate::math::whole).

#![allow(missing_docs)]

use super::builder::Callee;
use super::slot::Called;
use crate::math::{Integer, whole};

/// What such a companion returns.
macro_rules! told {
    ([$kept:ident] $result:ty) => { Called<impl Callee + use<$kept>, $result> };
}

macro_rules! companions {
    ($($companion:ident($($operand:ident),*): $function:ident -> $result:ty;)*) => {
        /// Methods of integers.
        pub trait WholeBuiltins: Sized {$(
            fn $companion(self $(, $operand: Self)*) -> told!([Self] $result);
        )*}

        impl<T: Integer> WholeBuiltins for T {$(
            fn $companion(self $(, $operand: T)*) -> told!([T] $result) {
                whole::$function::__call(self $(, $operand)*)
            }
        )*}
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
