//! Companions of comparisons that return an `Ordering`, and of its methods.

#![allow(missing_docs)]

use core::cmp::{Ordering, Reverse};

use bessemer_tree::Ty;

use super::builder::{Builder, Callee};
use super::companions::{calls, companions};
use super::numbers;
use super::slot::{Called, DslType, Seen, Value, dsl_types};
use crate::comparison;
use crate::math::Real;

dsl_types! {
    [] [] Ordering as Self => |cx| comparison::Ordering::ty(cx);
    [T: Value] [T: Seen] Reverse<T> as Reverse<T::Slot> => |cx| comparison::Reverse::<T>::ty(cx);
}

/// Types with a derived order: plain enums, structs, tuples and arrays.
pub trait Ranked: Value {}

impl<A: Value, B: Value> Ranked for (A, B) {}
impl<A: Value, B: Value, C: Value> Ranked for (A, B, C) {}
impl<A: Value, B: Value, C: Value, D: Value> Ranked for (A, B, C, D) {}
impl<T: Value, const N: usize> Ranked for [T; N] {}
impl<T: Value> Ranked for Reverse<T> {}

/// Types that a function of the DSL compares: [`Ranked`] types, integers and `bool`.
pub trait Compared: Value {}

impl<T: Ranked> Compared for T {}

companions! {
    pub mod traits[];
    /// Companions of [`Compared`] types.
    pub trait CompareBuiltins: Sized {
        fn __b_cmp(&self, _other: &Self) -> Ordering where Self: Ord = [comparison::__function_compare<Self>];
        fn __b_partial_cmp(&self, _other: &Self) -> Option<Ordering> where Self: PartialOrd
            = [comparison::__function_partial<Self>];
    }
    /// Companions of the methods by which `==`, `<` and the like may be written.
    pub trait EqualBuiltins: Sized {
        fn __b_eq(&self, _other: &Self) -> bool where Self: PartialEq = [comparison::__function_equal<Self>];
        fn __b_ne(&self, _other: &Self) -> bool where Self: PartialEq = [comparison::__function_unequal<Self>];
        fn __b_lt(&self, _other: &Self) -> bool where Self: PartialOrd = [comparison::__function_below<Self>];
        fn __b_le(&self, _other: &Self) -> bool where Self: PartialOrd = [comparison::__function_at_most<Self>];
        fn __b_gt(&self, _other: &Self) -> bool where Self: PartialOrd = [comparison::__function_above<Self>];
        fn __b_ge(&self, _other: &Self) -> bool where Self: PartialOrd = [comparison::__function_at_least<Self>];
    }
    /// Companions of `min`, `max` and `clamp` for these types.
    pub trait RankedOrderBuiltins: Sized {
        fn __b_min(self, _other: Self) -> Self = [comparison::__function_lesser<Self>];
        fn __b_max(self, _other: Self) -> Self = [comparison::__function_greater<Self>];
        fn __b_clamp(self, _low: Self, _high: Self) -> Self = [comparison::__function_limited<Self>];
    }
    /// Companions for references to types with `Ord`, where rustc finds the method before it dereferences. The
    /// function is that for values, since its result can only be read.
    impl[T: Extremes] ReferredOrderBuiltins<T> for &T {
        fn __b_min(self, _other: Self) -> Self = [T::Min];
        fn __b_max(self, _other: Self) -> Self = [T::Max];
        fn __b_clamp(self, _low: Self, _high: Self) -> Self = [T::Clamp];
    }
    /// Companions of floats.
    pub trait FloatCompareBuiltins: Sized {
        fn __b_partial_cmp(&self, _other: &Self) -> Option<Ordering> = [comparison::__function_partial<Self>];
        fn __b_total_cmp(&self, _other: &Self) -> Ordering = [comparison::__function_total<Self>];
    }
}

impl<T: Compared + Copy> CompareBuiltins for T {}
impl<T: Value + Copy> EqualBuiltins for T {}
impl<T: Ranked + Copy + Ord> RankedOrderBuiltins for T {}
impl<T: Value + Real> FloatCompareBuiltins for T {}

/// Types of `core::cmp::max` and `core::cmp::min`.
#[diagnostic::on_unimplemented(
    message = "`core::cmp::max` and `core::cmp::min` do not accept `{Self}`"
)]
pub trait Extremes: Sized {
    type Min: Callee;
    type Max: Callee;
    type Clamp: Callee;
}

impl<T: Ranked + Copy + Ord> Extremes for T {
    type Min = comparison::__function_lesser<T>;
    type Max = comparison::__function_greater<T>;
    type Clamp = comparison::__function_limited<T>;
}

macro_rules! integers {
    ($($ty:ident)*) => {$(
        impl Compared for $ty {}
        impl Extremes for $ty {
            type Min = numbers::Min;
            type Max = numbers::Max;
            type Clamp = numbers::Clamp;
        }
    )*};
}

integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }

impl Compared for bool {}
macro_rules! wide {
    ($($ty:ident)*) => {$(
        impl Compared for $ty {}
        impl Extremes for $ty {
            type Min = comparison::__function_lesser<$ty>;
            type Max = comparison::__function_greater<$ty>;
            type Clamp = comparison::__function_limited<$ty>;
        }
    )*};
}

wide! { u128 i128 }

/// Carriers of functions of `core::cmp`.
#[allow(non_camel_case_types)]
pub mod cmp {
    pub struct max;
    pub struct min;
}

calls! {
    cmp::max[T: Extremes](_one: T, _other: T) -> T = [T::Max];
    cmp::min[T: Extremes](_one: T, _other: T) -> T = [T::Min];
}
