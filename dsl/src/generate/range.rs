//! The companions of ranges that are held: structs of the DSL in the C.

#![allow(missing_docs)]

use core::ops::{Range, RangeInclusive};

use bessemer_ir::tree::Ty;

use super::builder::{Builder, Callee};
use super::factored::{gives, held};
use super::matrices::told;
use super::slot::{Called, DslType, Seen, Value};
use crate::range;

macro_rules! stands {
    ($($native:ident => $data:ident;)*) => {$(
        impl<T: Value> DslType for $native<T> {
            fn ty(cx: &mut Builder) -> Ty {
                range::$data::<T>::ty(cx)
            }
        }
        impl<T: Seen> Seen for $native<T> {
            type Slot = $native<T::Slot>;
        }
    )*};
}

stands! {
    RangeInclusive => Closed;
    Range => HalfOpen;
}

/// Methods of ranges with a last number.
pub trait ClosedBuiltins<T>: Sized {
    fn __b_new(start: T, end: T) -> told!([Self, T] => Self);
    fn __b_start(&self) -> told!([Self, T] => &T);
    fn __b_end(&self) -> told!([Self, T] => &T);
}

impl<T: Value + Copy> ClosedBuiltins<T> for RangeInclusive<T> {
    fn __b_new(start: T, end: T) -> told!([T] => Self) {
        gives(range::closed::__call(start, end))
    }
    fn __b_start(&self) -> told!([T] => &T) {
        range::start::__call(held::<_, range::Closed<T>>(self))
    }
    fn __b_end(&self) -> told!([T] => &T) {
        range::end::__call(held::<_, range::Closed<T>>(self))
    }
}

/// What ranges with and without a last number have.
pub trait RangeBuiltins<T>: Sized {
    fn __b_contains(&self, number: &T) -> told!([Self, T] => bool);
    fn __b_is_empty(&self) -> told!([Self, T] => bool);
}

impl<T: Value + Copy + PartialOrd> RangeBuiltins<T> for RangeInclusive<T> {
    fn __b_contains(&self, number: &T) -> told!([T] => bool) {
        range::closed_contains::__call(held(self), number)
    }
    fn __b_is_empty(&self) -> told!([T] => bool) {
        range::closed_is_empty::__call::<T>(held(self))
    }
}

impl<T: Value + Copy + PartialOrd> RangeBuiltins<T> for Range<T> {
    fn __b_contains(&self, number: &T) -> told!([T] => bool) {
        range::contains::__call(held(self), number)
    }
    fn __b_is_empty(&self) -> told!([T] => bool) {
        range::is_empty::__call::<T>(held(self))
    }
}
