//! Companions of the methods of slices, which arrays and lists also have.

use core::array::TryFromSliceError;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::{SliceMethod, Ty};
use nalgebra::SVector;

use super::builder::{Builder, Callee};
use super::companions::{companions, markers};
use super::iterator::Items;
use super::numbers::TryFromBuiltin;
use super::slot::{Called, DslType, Seen, Value, dsl_types, never_held};
use crate::math::Real;
use crate::{cut, search, slice_edit, sort};

companions! {
    pub mod traits[];
    /// Methods of slices.
    impl[T] SliceBuiltins<T> for [T] {
        fn __b_as_slice(&self) -> &[T] = AsSlice: Slice(SliceMethod::Whole);
        fn __b_as_mut_slice(&mut self) -> &mut [T] = AsSlice;
        fn __b_len(&self) -> usize = Len: Slice(SliceMethod::Len);
        fn __b_is_empty(&self) -> bool = IsEmpty: Slice(SliceMethod::IsEmpty);
        fn __b_first(&self) -> Option<&T> = First: Slice(SliceMethod::First);
        fn __b_last(&self) -> Option<&T> = Last: Slice(SliceMethod::Last);
        fn __b_get(&self, _index: usize) -> Option<&T> = Get: Slice(SliceMethod::Get);
        fn __b_swap(&mut self, _one: usize, _other: usize) -> () = [slice_edit::__function_swap<Copied<T>>];
        fn __b_fill(&mut self, _element: T) -> () = [slice_edit::__function_fill<Copied<T>>];
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
        fn __b_split_at_checked(&self, _at: usize) -> Option<(&[T], &[T])>
            = SplitAtChecked: Slice(SliceMethod::SplitAtChecked);
        fn __b_split_at_mut_checked(&mut self, _at: usize) -> Option<(&mut [T], &mut [T])> = SplitAtChecked;
        fn __b_split_first(&self) -> Option<(&T, &[T])> = SplitFirst: Slice(SliceMethod::SplitFirst);
        fn __b_split_first_mut(&mut self) -> Option<(&mut T, &mut [T])> = SplitFirst;
        fn __b_split_last(&self) -> Option<(&T, &[T])> = SplitLast: Slice(SliceMethod::SplitLast);
        fn __b_split_last_mut(&mut self) -> Option<(&mut T, &mut [T])> = SplitLast;
    }
    /// Companions of methods that return the beginning of a slice as an array.
    impl[T] SliceArrays<T> for [T] {
        fn __b_first_chunk[const N: usize](&self) -> Option<&[T; N]> = FirstChunk: Slice(SliceMethod::FirstChunk);
        fn __b_split_first_chunk[const N: usize](&self) -> Option<(&[T; N], &[T])> = [SplitFirstChunk<N>];
        fn __b_split_last_chunk[const N: usize](&self) -> Option<(&[T], &[T; N])> = [SplitLastChunk<N>];
    }
    /// Companions of iterators over parts of slices.
    impl[T: Seen] SliceCuts<T> for [T] {
        fn __b_iter['a](&'a self) -> Items<&'a T> = [cut::__function_iter<T::Slot>];
        fn __b_iter_mut['a](&'a mut self) -> Items<&'a mut T> = [cut::__function_iter_mut<T::Slot>];
        fn __b_split['a, F: FnMut(&T) -> bool](&'a self, _: F) -> Items<&'a [T]> = [cut::__function_split<T::Slot>];
        fn __b_split_inclusive['a, F: FnMut(&T) -> bool](&'a self, _: F) -> Items<&'a [T]>
            = [cut::__function_split_inclusive<T::Slot>];
        fn __b_chunk_by['a, F: FnMut(&T, &T) -> bool](&'a self, _: F) -> Items<&'a [T]>
            = [cut::__function_chunk_by<T::Slot>];
    }
    /// Companion of a search in a sorted slice.
    impl[T: Value + Copy + Ord] SliceSearch<T> for [T] {
        fn __b_binary_search(&self, _wanted: &T) -> Result<usize, usize> = [search::__function_binary_search<T>];
    }
    /// Companions of searches by a key.
    impl[T: Value + Copy] SliceSearches<T> for [T] {
        fn __b_binary_search_by_key[B: Value + Copy + Ord, F: Fn(&T) -> B](&self, _wanted: &B, _key: F) -> Result<usize, usize>
            = [search::__function_binary_search_by_key<T, B>];
    }
    /// Order of floats by `total_cmp`, which is a function in the C.
    pub trait TotalOrder: Sized {
        fn __b_total_below(&self, _other: &Self) -> bool = [sort::__function_below<Self>];
    }
    /// Companions of vectors as slices.
    impl[T, const N: usize] VectorSliceBuiltins<T, N> for SVector<T, N> {
        fn __b_as_slice(&self) -> &[T] = [AsSlice];
        fn __b_as_mut_slice(&mut self) -> &mut [T] = [AsSlice];
    }
}

/// Marker for an element that need not be `Copy` in Rust; the C copies it.
pub struct Copied<T>(PhantomData<T>);

impl<T> Clone for Copied<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Copied<T> {}

dsl_types! {
    [T: DslType] [T] Copied<T> as Self => |cx| T::ty(cx);
    [] [] TryFromSliceError as Self => |_| Ty::Unit;
}

never_held! { [T] Copied<T>; }

markers! {
    ToArray: Slice(SliceMethod::ToArray);
}

impl<T, const N: usize> TryFromBuiltin<&[T]> for [T; N] {
    type Marker = ToArray;
    type Error = TryFromSliceError;
}

// What is read only may be a copy.
impl<'a, T, const N: usize> TryFromBuiltin<&'a [T]> for &'a [T; N] {
    type Marker = ToArray;
    type Error = TryFromSliceError;
}

impl<T, const N: usize> TryFromBuiltin<&mut [T]> for [T; N] {
    type Marker = ToArray;
    type Error = TryFromSliceError;
}

/// Defines markers of methods whose name contains a number of elements.
macro_rules! chunks {
    ($($method:ident)*) => {$(
        #[doc = concat!("The marker of `", stringify!($method), "`.")]
        pub struct $method<const N: usize>;
        impl<const N: usize> Callee for $method<N> {
            fn callee(_: &mut Builder) -> tree::Callee {
                // A size beyond 32 bits is never one of a slice that is there.
                let count = u32::try_from(N).unwrap_or(u32::MAX);
                tree::Callee::Builtin(tree::Builtin::Slice(SliceMethod::$method(count)))
            }
        }
    )*};
}

chunks! { SplitFirstChunk SplitLastChunk }

impl<T: Value + Real> TotalOrder for T {}
