//! The companions of the methods of slices, which arrays and lists have too.

use core::array::TryFromSliceError;
use core::cmp::Ordering;
use core::marker::PhantomData;

use bessemer_ir::tree::{self, SliceMethod, Ty};
use nalgebra::SVector;

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::matrices::told;
use super::numbers::TryFromBuiltin;
use super::slot::{Called, Companion, DslType, Seen, Value};
use crate::math::Real;
use crate::{Number, Plain, search, slice_edit, sort};

markers! {
    AsSlice: Slice(SliceMethod::Whole);
    Len: Slice(SliceMethod::Len);
    IsEmpty: Slice(SliceMethod::IsEmpty);
    First: Slice(SliceMethod::First);
    Last: Slice(SliceMethod::Last);
    Get: Slice(SliceMethod::Get);
    CopyFrom: Slice(SliceMethod::CopyFrom);
    Reverse: Slice(SliceMethod::Reverse);
    GetMut: Slice(SliceMethod::GetMut);
    GetPart: Slice(SliceMethod::GetPart);
    GetFrom: Slice(SliceMethod::GetFrom);
    FirstMut: Slice(SliceMethod::FirstMut);
    LastMut: Slice(SliceMethod::LastMut);
    SplitAt: Slice(SliceMethod::SplitAt);
    SplitFirst: Slice(SliceMethod::SplitFirst);
    SplitLast: Slice(SliceMethod::SplitLast);
    ToArray: Slice(SliceMethod::ToArray);
    FirstChunk: Slice(SliceMethod::FirstChunk);
}

/// Methods of slices.
#[allow(missing_docs)]
pub trait SliceBuiltins<T> {
    signatures! {
        fn __b_as_slice(&self) -> Called<AsSlice, &[T]>;
        fn __b_as_mut_slice(&mut self) -> Called<AsSlice, &mut [T]>;
        fn __b_len(&self) -> Called<Len, usize>;
        fn __b_is_empty(&self) -> Called<IsEmpty, bool>;
        fn __b_first(&self) -> Called<First, Option<&T>>;
        fn __b_last(&self) -> Called<Last, Option<&T>>;
        fn __b_get(&self, _index: usize) -> Called<Get, Option<&T>>;
        fn __b_swap(&mut self, _one: usize, _other: usize) -> Called<Swap<T>, ()>;
        fn __b_fill(&mut self, _element: T) -> Called<Fill<T>, ()>;
        fn __b_copy_from_slice(&mut self, _from: &[T]) -> Called<CopyFrom, ()>;
        fn __b_reverse(&mut self) -> Called<Reverse, ()>;
        fn __b_get_mut(&mut self, _index: usize) -> Called<GetMut, Option<&mut T>>;
        fn __b_slice_get_part(&self, _from: usize, _to: usize) -> Called<GetPart, Option<&[T]>>;
        fn __b_slice_get_mut_part(
            &mut self, _from: usize, _to: usize
        ) -> Called<GetPart, Option<&mut [T]>>;
        fn __b_slice_get_rest(&self, _from: usize) -> Called<GetFrom, Option<&[T]>>;
        fn __b_slice_get_mut_rest(&mut self, _from: usize) -> Called<GetFrom, Option<&mut [T]>>;
        fn __b_first_mut(&mut self) -> Called<FirstMut, Option<&mut T>>;
        fn __b_last_mut(&mut self) -> Called<LastMut, Option<&mut T>>;
        fn __b_split_at(&self, _at: usize) -> Called<SplitAt, (&[T], &[T])>;
        fn __b_split_at_mut(&mut self, _at: usize) -> Called<SplitAt, (&mut [T], &mut [T])>;
        fn __b_split_first(&self) -> Called<SplitFirst, Option<(&T, &[T])>>;
        fn __b_split_first_mut(&mut self) -> Called<SplitFirst, Option<(&mut T, &mut [T])>>;
        fn __b_split_last(&self) -> Called<SplitLast, Option<(&T, &[T])>>;
        fn __b_split_last_mut(&mut self) -> Called<SplitLast, Option<(&mut T, &mut [T])>>;
    }
}

impl<T> SliceBuiltins<T> for [T] {}

/// Stands for an element that need not be `Copy` in Rust: the C copies it.
pub struct Copied<T>(PhantomData<T>);

impl<T> Clone for Copied<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Copied<T> {}

impl<T: DslType> DslType for Copied<T> {
    fn ty(cx: &mut Builder) -> Ty {
        T::ty(cx)
    }
}

impl<T> Seen for Copied<T> {
    type Slot = Copied<T>;
}

impl<T> Plain for Copied<T> {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {
        unreachable!("a witness copy is never run")
    }
}

/// The markers of functions of such elements.
macro_rules! of_any {
    ($($marker:ident: $function:ident($($parameter:ty),*);)*) => {$(
        #[doc = concat!("The marker of `", stringify!($function), "`.")]
        pub struct $marker<T>(PhantomData<T>);
        impl<T: DslType + 'static> Callee for $marker<T> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                let function = slice_edit::$function::__call as fn($($parameter),*) -> _;
                Companion::callee(function, cx)
            }
        }
    )*};
}

of_any! {
    Swap: swap(&'static mut [Copied<T>], usize, usize);
    Fill: fill(&'static mut [Copied<T>], Copied<T>);
}

impl<T, const N: usize> TryFromBuiltin<&[T]> for [T; N] {
    type Marker = ToArray;
    type Error = TryFromSliceError;
}

impl<T, const N: usize> TryFromBuiltin<&mut [T]> for [T; N] {
    type Marker = ToArray;
    type Error = TryFromSliceError;
}

impl DslType for TryFromSliceError {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Unit
    }
}

impl Seen for TryFromSliceError {
    type Slot = TryFromSliceError;
}

/// The beginnings of slices as arrays.
#[allow(missing_docs)]
pub trait SliceArrays<T> {
    fn __b_first_chunk<const N: usize>(&self) -> Called<FirstChunk, Option<&[T; N]>> {
        unreachable!()
    }
    #[allow(clippy::type_complexity)]
    fn __b_split_first_chunk<const N: usize>(
        &self,
    ) -> Called<SplitFirstChunk<N>, Option<(&[T; N], &[T])>> {
        unreachable!()
    }
    #[allow(clippy::type_complexity)]
    fn __b_split_last_chunk<const N: usize>(
        &self,
    ) -> Called<SplitLastChunk<N>, Option<(&[T], &[T; N])>> {
        unreachable!()
    }
}

/// The marker of `split_first_chunk`, which says how many elements are the first.
pub struct SplitFirstChunk<const N: usize>;

/// The marker of `split_last_chunk`, which says how many elements are the last.
pub struct SplitLastChunk<const N: usize>;

impl<const N: usize> Callee for SplitFirstChunk<N> {
    fn callee(_: &mut Builder) -> tree::Callee {
        chunk::<N>(SliceMethod::SplitFirstChunk)
    }
}

impl<const N: usize> Callee for SplitLastChunk<N> {
    fn callee(_: &mut Builder) -> tree::Callee {
        chunk::<N>(SliceMethod::SplitLastChunk)
    }
}

fn chunk<const N: usize>(method: fn(u32) -> SliceMethod) -> tree::Callee {
    // A size beyond 32 bits is never one of a slice that is there.
    let count = u32::try_from(N).unwrap_or(u32::MAX);
    tree::Callee::Builtin(tree::Builtin::Slice(method(count)))
}

impl<T> SliceArrays<T> for [T] {}

/// Methods of slices that move elements: functions of the DSL in the C.
#[allow(missing_docs)]
pub trait SliceEdits<T> {
    fn __b_rotate_left(&mut self, by: usize) -> told!([Self, T] => ());
    fn __b_rotate_right(&mut self, by: usize) -> told!([Self, T] => ());
    fn __b_slice_copy_within_part(
        &mut self,
        from: usize,
        to: usize,
        place: usize,
    ) -> told!([Self, T] => ());
    fn __b_slice_copy_within_rest(&mut self, from: usize, place: usize) -> told!([Self, T] => ());
}

impl<T: Value + Copy> SliceEdits<T> for [T] {
    fn __b_rotate_left(&mut self, by: usize) -> told!([T] => ()) {
        slice_edit::rotate_left::__call(self, by)
    }
    fn __b_rotate_right(&mut self, by: usize) -> told!([T] => ()) {
        slice_edit::rotate_right::__call(self, by)
    }
    fn __b_slice_copy_within_part(
        &mut self,
        from: usize,
        to: usize,
        place: usize,
    ) -> told!([T] => ()) {
        slice_edit::copy_within::__call(self, from, to, place)
    }
    fn __b_slice_copy_within_rest(&mut self, from: usize, place: usize) -> told!([T] => ()) {
        slice_edit::copy_behind_within::__call(self, from, place)
    }
}

/// Methods of slices of numbers that compare their ends: functions of the DSL in the C.
#[allow(missing_docs)]
pub trait SliceEnds<T> {
    fn __b_starts_with(&self, start: &[T]) -> told!([Self, T] => bool);
    fn __b_ends_with(&self, end: &[T]) -> told!([Self, T] => bool);
}

impl<T: Value + Number + PartialEq> SliceEnds<T> for [T] {
    fn __b_starts_with(&self, start: &[T]) -> told!([T] => bool) {
        slice_edit::starts_with::__call(self, start)
    }
    fn __b_ends_with(&self, end: &[T]) -> told!([T] => bool) {
        slice_edit::ends_with::__call(self, end)
    }
}

/// Methods of slices of integers that are functions of the DSL in the C.
#[allow(missing_docs)]
pub trait SliceSorts<T> {
    fn __b_sort(&mut self) -> told!([Self, T] => ());
    fn __b_sort_unstable(&mut self) -> told!([Self, T] => ());
}

impl<T: Value + Number + Ord> SliceSorts<T> for [T] {
    fn __b_sort(&mut self) -> told!([T] => ()) {
        sort::ascending::__call(self)
    }
    fn __b_sort_unstable(&mut self) -> told!([T] => ()) {
        sort::ascending::__call(self)
    }
}

/// Methods of sorted slices: functions of the DSL in the C.
#[allow(missing_docs)]
pub trait SliceSearches<T> {
    fn __b_binary_search(&self, wanted: &T) -> told!([Self, T] => Result<usize, usize>)
    where
        T: Ord;
    fn __b_binary_search_by<F: Fn(&T) -> Ordering>(
        &self,
        order: F,
    ) -> told!([Self, T] + F => Result<usize, usize>);
    fn __b_binary_search_by_key<B: Value + Copy + Ord, F: Fn(&T) -> B>(
        &self,
        wanted: &B,
        key: F,
    ) -> told!([Self, T] + B + F => Result<usize, usize>);
    fn __b_partition_point<F: Fn(&T) -> bool>(&self, is_first: F) -> told!([Self, T] + F => usize);
}

impl<T: Value + Copy> SliceSearches<T> for [T] {
    fn __b_binary_search(&self, wanted: &T) -> told!([T] => Result<usize, usize>)
    where
        T: Ord,
    {
        search::binary_search::__call(self, *wanted)
    }
    fn __b_binary_search_by<F: Fn(&T) -> Ordering>(
        &self,
        order: F,
    ) -> told!([T] + F => Result<usize, usize>) {
        search::binary_search_by::__call(self, order)
    }
    fn __b_binary_search_by_key<B: Value + Copy + Ord, F: Fn(&T) -> B>(
        &self,
        wanted: &B,
        key: F,
    ) -> told!([T] + B + F => Result<usize, usize>) {
        search::binary_search_by_key::__call(self, *wanted, key)
    }
    fn __b_partition_point<F: Fn(&T) -> bool>(&self, is_first: F) -> told!([T] + F => usize) {
        search::partition_point::__call(self, is_first)
    }
}

/// Methods of slices whose elements have `==`.
#[allow(missing_docs)]
pub trait SliceEquals<T> {
    fn __b_contains(&self, element: &T) -> told!([Self, T] => bool);
}

impl<T: Value + PartialEq> SliceEquals<T> for [T] {
    fn __b_contains(&self, element: &T) -> told!([T] => bool) {
        slice_edit::contains::__call(self, element)
    }
}

/// Methods of slices whose elements have `<`.
#[allow(missing_docs)]
pub trait SliceOrder<T> {
    fn __b_is_sorted(&self) -> told!([Self, T] => bool);
}

impl<T: Value + PartialOrd> SliceOrder<T> for [T] {
    fn __b_is_sorted(&self) -> told!([T] => bool) {
        sort::is_sorted::__call(self)
    }
}

/// The order of floats in `total_cmp`, which the C has as a function.
#[allow(missing_docs)]
pub trait TotalOrder: Sized {
    fn __b_total_below(&self, other: &Self) -> told!([Self] => bool);
}

impl<T: Value + Real> TotalOrder for T {
    fn __b_total_below(&self, other: &T) -> told!([T] => bool) {
        sort::below::__call(*self, *other)
    }
}

/// Vectors as slices.
#[allow(missing_docs)]
pub trait VectorSliceBuiltins<T> {
    fn __b_as_slice(&self) -> Called<AsSlice, &[T]> {
        unreachable!()
    }
    fn __b_as_mut_slice(&mut self) -> Called<AsSlice, &mut [T]> {
        unreachable!()
    }
}

impl<T, const N: usize> VectorSliceBuiltins<T> for SVector<T, N> {}
