//! The companions of core's `NonZeroU32` and its like, a struct of the DSL in the C.

#![allow(missing_docs)]

use core::num::NonZero;

use bessemer_ir::tree::{self, Ty};

use super::builder::{Builder, Callee};
use super::factored::{gives, held};
use super::matrices::told;
use super::numbers::FromBuiltin;
use super::slot::{Called, DslType, Seen};
use super::spatial::of;
use crate::non_zero;

/// Methods of integers that are not zero.
pub trait NonZeroBuiltins<T>: Sized {
    fn __b_new(value: T) -> told!([Self, T] => Option<Self>);
    fn __b_get(self) -> told!([Self, T] => T);
}

/// The marker of `u32::from` of a `NonZeroU32`.
pub struct Integer<T>(core::marker::PhantomData<fn() -> T>);

macro_rules! integers {
    ($($int:ident)*) => {$(
        impl DslType for NonZero<$int> {
            fn ty(cx: &mut Builder) -> Ty {
                non_zero::NonZero::<$int>::ty(cx)
            }
        }
        impl Seen for NonZero<$int> {
            type Slot = Self;
        }
        impl NonZeroBuiltins<$int> for NonZero<$int> {
            fn __b_new(value: $int) -> told!([] => Option<Self>) {
                gives(non_zero::new::__call(value))
            }
            fn __b_get(self) -> told!([] => $int) {
                non_zero::get::__call::<$int>(*held(&self))
            }
        }
        impl Callee for Integer<$int> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                of(cx, non_zero::get::__call::<$int>)
            }
        }
        impl FromBuiltin<NonZero<$int>> for $int {
            type Marker = Integer<$int>;
        }
    )*};
}

integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }
