//! The companions of core's `NonZeroU32` and its like, a struct of the DSL in the C.

#![allow(missing_docs)]

use core::num::NonZero;

use bessemer_ir::tree::Ty;

use super::builder::Builder;
use super::builtin::companions;
use super::numbers::FromBuiltin;
use super::slot::{Called, DslType, Seen, stands};
use crate::non_zero;

companions! {
    /// Methods of integers that are not zero.
    pub trait NonZeroBuiltins[T]: Sized {
        fn __b_new(_value: T) -> Option<Self> = [non_zero::__function_new<T>];
        fn __b_get(self) -> T = [non_zero::__function_get<T>];
    }
}

macro_rules! integers {
    ($($int:ident)*) => {$(
        stands! { [] NonZero<$int> => non_zero::NonZero<$int>; }
        impl NonZeroBuiltins<$int> for NonZero<$int> {}
        impl FromBuiltin<NonZero<$int>> for $int {
            type Marker = non_zero::__function_get<$int>;
        }
    )*};
}

integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }
