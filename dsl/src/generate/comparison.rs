//! The companions of comparisons that give an `Ordering`, and of its methods.

#![allow(missing_docs)]

use core::cmp::{Ordering, Reverse};

use bessemer_ir::tree::Ty;

use super::builder::{Builder, Callee};
use super::builtin::{OrderBuiltins, signatures};
use super::matrices::{told, told_methods};
use super::slot::{Called, DslType, Seen, Value};
use crate::comparison;
use crate::math::Real;

impl DslType for Ordering {
    fn ty(cx: &mut Builder) -> Ty {
        comparison::Ordering::ty(cx)
    }
}

impl Seen for Ordering {
    type Slot = Ordering;
}

impl<T: Value> DslType for Reverse<T> {
    fn ty(cx: &mut Builder) -> Ty {
        comparison::Reverse::<T>::ty(cx)
    }
}

impl<T: Seen> Seen for Reverse<T> {
    type Slot = Reverse<T::Slot>;
}

/// What integers and `bool` have.
pub trait CompareBuiltins: Sized {
    fn __b_cmp(&self, other: &Self) -> told!([Self] => Ordering);
}

/// What all numbers have.
pub trait PartialCompareBuiltins: Sized {
    fn __b_partial_cmp(&self, other: &Self) -> told!([Self] => Option<Ordering>);
}

macro_rules! ordered {
    ($($ty:ident)*) => {$(
        impl CompareBuiltins for $ty {
            fn __b_cmp(&self, other: &$ty) -> told!([] => Ordering) {
                comparison::compare::__call(*self, *other)
            }
        }
        impl PartialCompareBuiltins for $ty {
            fn __b_partial_cmp(&self, other: &$ty) -> told!([] => Option<Ordering>) {
                comparison::partial::__call(*self, *other)
            }
        }
    )*};
}

ordered! { bool i8 i16 i32 i64 isize u8 u16 u32 u64 usize }

impl<T: Value + Real> PartialCompareBuiltins for T {
    fn __b_partial_cmp(&self, other: &T) -> told!([T] => Option<Ordering>) {
        comparison::partial::__call(*self, *other)
    }
}

/// What has an order of its own: plain enums that derive that of their numbers, structs that derive that of their
/// parts, tuples and arrays.
pub trait Ranked: Value {}

impl<A: Value, B: Value> Ranked for (A, B) {}
impl<A: Value, B: Value, C: Value> Ranked for (A, B, C) {}
impl<A: Value, B: Value, C: Value, D: Value> Ranked for (A, B, C, D) {}
impl<T: Value, const N: usize> Ranked for [T; N] {}
impl<T: Value> Ranked for Reverse<T> {}

/// What these have.
pub trait RankedBuiltins: Sized {
    fn __b_cmp(&self, other: &Self) -> told!([Self] => Ordering)
    where
        Self: Ord;
    fn __b_partial_cmp(&self, other: &Self) -> told!([Self] => Option<Ordering>)
    where
        Self: PartialOrd;
}

impl<T: Ranked + Copy> RankedBuiltins for T {
    fn __b_cmp(&self, other: &T) -> told!([T] => Ordering)
    where
        T: Ord,
    {
        comparison::compare::__call(*self, *other)
    }
    fn __b_partial_cmp(&self, other: &T) -> told!([T] => Option<Ordering>)
    where
        T: PartialOrd,
    {
        comparison::partial::__call(*self, *other)
    }
}

told_methods! {
    /// The least and the greatest of them.
    RankedOrderBuiltins<> [Self]: Sized for (T: (Ranked + Copy + Ord)) T, [T] {
        fn __b_min(self, other: Self) -> Self { comparison::lesser::__call(self, other) }
        fn __b_max(self, other: Self) -> Self { comparison::greater::__call(self, other) }
        fn __b_clamp(self, low: Self, high: Self) -> Self {
            comparison::limited::__call(self, low, high)
        }
    }
}

/// The same of references to what has `Ord`: rustc finds it there before it looks behind the reference.
pub trait ReferredOrderBuiltins: Sized {
    fn __b_min(self, other: Self) -> told!([Self] => Self);
    fn __b_max(self, other: Self) -> told!([Self] => Self);
    fn __b_clamp(self, low: Self, high: Self) -> told!([Self] => Self);
}

/// The function is that of the values: what it gives can only be read.
fn referred<'a, M, T>(_: Called<M, T>) -> Called<M, &'a T> {
    unreachable!("a witness copy is never run")
}

// The marker of what is called outlives the reference.
#[allow(refining_impl_trait)]
impl<'a, T: Ranked + Copy + Ord> ReferredOrderBuiltins for &'a T {
    fn __b_min(self, other: &'a T) -> told!([T] => &'a T) {
        referred(comparison::lesser::__call(*self, *other))
    }
    fn __b_max(self, other: &'a T) -> told!([T] => &'a T) {
        referred(comparison::greater::__call(*self, *other))
    }
    fn __b_clamp(self, low: &'a T, high: &'a T) -> told!([T] => &'a T) {
        referred(comparison::limited::__call(*self, *low, *high))
    }
}

/// What `core::cmp::max` and `core::cmp::min` take.
#[diagnostic::on_unimplemented(
    message = "`core::cmp::max` and `core::cmp::min` do not take `{Self}` in the DSL"
)]
pub trait Extremes: Sized {
    fn __max(self, other: Self) -> told!([Self] => Self);
    fn __min(self, other: Self) -> told!([Self] => Self);
}

impl<T: Ranked + Copy + Ord> Extremes for T {
    fn __max(self, other: T) -> told!([T] => T) {
        comparison::greater::__call(self, other)
    }
    fn __min(self, other: T) -> told!([T] => T) {
        comparison::lesser::__call(self, other)
    }
}

macro_rules! extremes {
    ($($ty:ident)*) => {$(
        #[allow(refining_impl_trait)]
        impl<'a> ReferredOrderBuiltins for &'a $ty {
            fn __b_min(self, other: &'a $ty) -> told!([] => &'a $ty) {
                referred(OrderBuiltins::__b_min(*self, *other))
            }
            fn __b_max(self, other: &'a $ty) -> told!([] => &'a $ty) {
                referred(OrderBuiltins::__b_max(*self, *other))
            }
            fn __b_clamp(self, low: &'a $ty, high: &'a $ty) -> told!([] => &'a $ty) {
                referred(OrderBuiltins::__b_clamp(*self, *low, *high))
            }
        }
        impl Extremes for $ty {
            fn __max(self, other: $ty) -> told!([] => $ty) {
                OrderBuiltins::__b_max(self, other)
            }
            fn __min(self, other: $ty) -> told!([] => $ty) {
                OrderBuiltins::__b_min(self, other)
            }
        }
    )*};
}

extremes! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }

/// What stands for the functions of that module.
#[allow(non_camel_case_types)]
pub mod cmp {
    use super::*;

    pub struct max;
    pub struct min;

    impl max {
        pub fn __call<T: Extremes>(one: T, other: T) -> told!([T] => T) {
            one.__max(other)
        }
    }

    impl min {
        pub fn __call<T: Extremes>(one: T, other: T) -> told!([T] => T) {
            one.__min(other)
        }
    }
}

told_methods! {
    /// What floats have.
    TotalCompareBuiltins<> [Self]: Sized for (T: (Value + Real)) T, [T] {
        fn __b_total_cmp(&self, other: &Self) -> Ordering { comparison::total::__call(*self, *other) }
    }
}

told_methods! {
    /// Methods of `Ordering`.
    OrderingBuiltins<> [Self]: Sized for () Ordering, [] {
        fn __b_reverse(self) -> Ordering { comparison::reversed::__call(self) }
        fn __b_then(self, next: Ordering) -> Ordering { comparison::then::__call(self, next) }
        fn __b_is_lt(self) -> bool { comparison::is_less::__call(self) }
        fn __b_is_le(self) -> bool { comparison::is_at_most::__call(self) }
        fn __b_is_gt(self) -> bool { comparison::is_greater::__call(self) }
        fn __b_is_ge(self) -> bool { comparison::is_at_least::__call(self) }
        fn __b_is_eq(self) -> bool { comparison::is_equal::__call(self) }
        fn __b_is_ne(self) -> bool { comparison::is_unequal::__call(self) }
    }
}

/// What stands for a `match` on an `Ordering`.
pub trait ThenBuiltin: Sized {
    signatures! {
        fn __b_then_with(
            self, _next: impl FnOnce() -> Ordering
        ) -> Called<comparison::then_with, Ordering>;
    }
}

impl ThenBuiltin for Ordering {}
