//! The companions of ranges that are held: structs of the DSL in the C.

#![allow(missing_docs)]

use core::ops::{Range, RangeInclusive};

use bessemer_ir::tree::Ty;

use super::builder::{Builder, Callee};
use super::factored::{gives, held};
use super::matrices::{told, told_methods};
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

told_methods! {
    /// Methods of ranges with a last number.
    ClosedBuiltins<T> [Self, T]: Sized for (T: (Value + Copy)) RangeInclusive<T>, [T] {
        fn __b_new(start: T, end: T) -> Self { gives(range::closed::__call(start, end)) }
        fn __b_start(&self) -> &T { range::start::__call(held::<_, range::Closed<T>>(self)) }
        fn __b_end(&self) -> &T { range::end::__call(held::<_, range::Closed<T>>(self)) }
    }
}

/// What ranges with and without a last number have.
macro_rules! of_ranges {
    ($($trait:ident $range:ident $contains:ident $is_empty:ident;)*) => {$(told_methods! {
        /// What a range contains.
        $trait<T> [Self, T]: Sized for (T: (Value + Copy + PartialOrd)) $range<T>, [T] {
            fn __b_contains(&self, number: &T) -> bool { range::$contains::__call(held(self), number) }
            fn __b_is_empty(&self) -> bool { range::$is_empty::__call::<T>(held(self)) }
        }
    })*};
}

of_ranges! {
    ClosedContents RangeInclusive closed_contains closed_is_empty;
    Contents Range contains is_empty;
}
