//! The companions of the methods of slices, which arrays and lists have too.

use core::array::TryFromSliceError;
use core::cmp::Ordering;
use core::marker::PhantomData;

use bessemer_ir::tree::{self, SliceMethod, Ty};
use nalgebra::SVector;

use super::builder::{Builder, Callee};
use super::builtin::{markers, operations};
use super::matrices::{told, told_methods};
use super::numbers::TryFromBuiltin;
use super::slot::{Called, Companion, DslType, Seen, Value};
use crate::math::Real;
use crate::{Number, Plain, search, slice_edit, sort};

markers! {
    ToArray: Slice(SliceMethod::ToArray);
    FirstChunk: Slice(SliceMethod::FirstChunk);
}

operations! {
    /// Methods of slices.
    pub trait SliceBuiltins<T> {
        fn __b_as_slice(&self) -> &[T] = AsSlice: Slice(SliceMethod::Whole);
        fn __b_as_mut_slice(&mut self) -> &mut [T] = AsSlice;
        fn __b_len(&self) -> usize = Len: Slice(SliceMethod::Len);
        fn __b_is_empty(&self) -> bool = IsEmpty: Slice(SliceMethod::IsEmpty);
        fn __b_first(&self) -> Option<&T> = First: Slice(SliceMethod::First);
        fn __b_last(&self) -> Option<&T> = Last: Slice(SliceMethod::Last);
        fn __b_get(&self, _index: usize) -> Option<&T> = Get: Slice(SliceMethod::Get);
        fn __b_swap(&mut self, _one: usize, _other: usize) -> () = Swap<T>;
        fn __b_fill(&mut self, _element: T) -> () = Fill<T>;
        fn __b_copy_from_slice(&mut self, _from: &[T]) -> () = CopyFrom: Slice(SliceMethod::CopyFrom);
        fn __b_reverse(&mut self) -> () = Reverse: Slice(SliceMethod::Reverse);
        fn __b_get_mut(&mut self, _index: usize) -> Option<&mut T> = GetMut: Slice(SliceMethod::GetMut);
        fn __b_slice_get_part(&self, _from: usize, _to: usize) -> Option<&[T]>
            = GetPart: Slice(SliceMethod::GetPart);
        fn __b_slice_get_mut_part(&mut self, _from: usize, _to: usize) -> Option<&mut [T]> = GetPart;
        fn __b_slice_get_rest(&self, _from: usize) -> Option<&[T]> = GetFrom: Slice(SliceMethod::GetFrom);
        fn __b_slice_get_mut_rest(&mut self, _from: usize) -> Option<&mut [T]> = GetFrom;
        fn __b_first_mut(&mut self) -> Option<&mut T> = FirstMut: Slice(SliceMethod::FirstMut);
        fn __b_last_mut(&mut self) -> Option<&mut T> = LastMut: Slice(SliceMethod::LastMut);
        fn __b_split_at(&self, _at: usize) -> (&[T], &[T]) = SplitAt: Slice(SliceMethod::SplitAt);
        fn __b_split_at_mut(&mut self, _at: usize) -> (&mut [T], &mut [T]) = SplitAt;
        fn __b_split_first(&self) -> Option<(&T, &[T])> = SplitFirst: Slice(SliceMethod::SplitFirst);
        fn __b_split_first_mut(&mut self) -> Option<(&mut T, &mut [T])> = SplitFirst;
        fn __b_split_last(&self) -> Option<(&T, &[T])> = SplitLast: Slice(SliceMethod::SplitLast);
        fn __b_split_last_mut(&mut self) -> Option<(&mut T, &mut [T])> = SplitLast;
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

told_methods! {
    /// Methods of slices that move elements: functions of the DSL in the C.
    SliceEdits<T> [Self, T] for (T: (Value + Copy)) [T], [T] {
        fn __b_rotate_left(&mut self, by: usize) -> () { slice_edit::rotate_left::__call(self, by) }
        fn __b_rotate_right(&mut self, by: usize) -> () { slice_edit::rotate_right::__call(self, by) }
        fn __b_slice_copy_within_part(&mut self, from: usize, to: usize, place: usize) -> () {
            slice_edit::copy_within::__call(self, from, to, place)
        }
        fn __b_slice_copy_within_rest(&mut self, from: usize, place: usize) -> () {
            slice_edit::copy_behind_within::__call(self, from, place)
        }
    }
}

told_methods! {
    /// Methods of slices of numbers that compare their ends: functions of the DSL in the C.
    SliceEnds<T> [Self, T] for (T: (Value + Number + PartialEq)) [T], [T] {
        fn __b_starts_with(&self, start: &[T]) -> bool { slice_edit::starts_with::__call(self, start) }
        fn __b_ends_with(&self, end: &[T]) -> bool { slice_edit::ends_with::__call(self, end) }
    }
}

told_methods! {
    /// Methods of slices of integers that are functions of the DSL in the C.
    SliceSorts<T> [Self, T] for (T: (Value + Number + Ord)) [T], [T] {
        fn __b_sort(&mut self) -> () { sort::ascending::__call(self) }
        fn __b_sort_unstable(&mut self) -> () { sort::ascending::__call(self) }
    }
}

told_methods! {
    /// The search of an element in a sorted slice.
    SliceSearch<T> [Self, T] for (T: (Value + Copy + Ord)) [T], [T] {
        fn __b_binary_search(&self, wanted: &T) -> Result<usize, usize> {
            search::binary_search::__call(self, *wanted)
        }
    }
}

told_methods! {
    /// Methods of sorted slices: functions of the DSL in the C.
    SliceSearches<T> [Self, T] for (T: (Value + Copy)) [T], [T] {
        fn __b_binary_search_by[F: (Fn(&T) -> Ordering)](&self, order: F) -> Result<usize, usize> {
            search::binary_search_by::__call(self, order)
        }
        fn __b_binary_search_by_key[B: (Value + Copy + Ord), F: (Fn(&T) -> B)](
            &self, wanted: &B, key: F
        ) -> Result<usize, usize> {
            search::binary_search_by_key::__call(self, *wanted, key)
        }
        fn __b_partition_point[F: (Fn(&T) -> bool)](&self, is_first: F) -> usize {
            search::partition_point::__call(self, is_first)
        }
    }
}

told_methods! {
    /// Methods of slices whose elements have `==`.
    SliceEquals<T> [Self, T] for (T: (Value + PartialEq)) [T], [T] {
        fn __b_contains(&self, element: &T) -> bool { slice_edit::contains::__call(self, element) }
    }
}

told_methods! {
    /// Methods of slices whose elements have `<`.
    SliceOrder<T> [Self, T] for (T: (Value + PartialOrd)) [T], [T] {
        fn __b_is_sorted(&self) -> bool { sort::is_sorted::__call(self) }
    }
}

told_methods! {
    /// The order of floats in `total_cmp`, which the C has as a function.
    TotalOrder<> [Self] for (T: (Value + Real)) T, [T] {
        fn __b_total_below(&self, other: &Self) -> bool { sort::below::__call(*self, *other) }
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
