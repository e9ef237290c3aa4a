//! The companions of ranges that are held: structs of the DSL in the C.

#![allow(missing_docs)]

use core::ops::{Range, RangeInclusive};

use bessemer_ir::tree::Ty;

use super::builder::Builder;
use super::builtin::companions;
use super::slot::{Called, DslType, Seen, Value, dsl_types};
use crate::range;

dsl_types! {
    [T: Value] [T: Seen] RangeInclusive<T> as RangeInclusive<T::Slot> => |cx| range::Closed::<T>::ty(cx);
    [T: Value] [T: Seen] Range<T> as Range<T::Slot> => |cx| range::HalfOpen::<T>::ty(cx);
}

companions! {
    /// Methods of ranges with a last number.
    impl[T: Value + Copy] ClosedBuiltins<T> for RangeInclusive<T> {
        fn __b_new(_start: T, _end: T) -> Self = [range::__function_closed<T>];
        fn __b_start(&self) -> &T = [range::__function_start<T>];
        fn __b_end(&self) -> &T = [range::__function_end<T>];
    }
    /// What a range with a last number contains.
    impl[T: Value + Copy + PartialOrd] ClosedContents<T> for RangeInclusive<T> {
        fn __b_contains(&self, _number: &T) -> bool = [range::__function_closed_contains<T>];
        fn __b_is_empty(&self) -> bool = [range::__function_closed_is_empty<T>];
    }
    /// What one without contains.
    impl[T: Value + Copy + PartialOrd] Contents<T> for Range<T> {
        fn __b_contains(&self, _number: &T) -> bool = [range::__function_contains<T>];
        fn __b_is_empty(&self) -> bool = [range::__function_is_empty<T>];
    }
}
