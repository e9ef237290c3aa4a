//! Companions of containers: `Option`, `Result`, arrays, lists, ranges and non-zero integers; those that are not
//! defined in the library.

#![allow(missing_docs)]

use core::num::NonZero;
use core::ops::{Range, RangeInclusive};

use bessemer_tree as tree;
use bessemer_tree::{Desugared, ListMethod, OptionMethod, Ty};

use super::builder::{Builder, Callee};
use super::companions::{calls, companions};
use super::numbers::{FromBuiltin, converts};
use super::slot::{Called, DslType, Seen, Value, dsl_types, stands};
use crate::{List, exchange, list_edit, name, non_zero, optional, range};

// Ranges that are held are structs of the DSL in the C.
dsl_types! {
    [T: Value] [T: Seen] RangeInclusive<T> as RangeInclusive<T::Slot> => |cx| range::Closed::<T>::ty(cx);
    [T: Value] [T: Seen] Range<T> as Range<T::Slot> => |cx| range::HalfOpen::<T>::ty(cx);
}

companions! {
    pub mod traits[];
    /// Methods of `Option`.
    impl[T] OptionBuiltins<T> for Option<T> {
        fn __b_unwrap(self) -> T = Unwrap: Option(OptionMethod::Unwrap);
        fn __b_expect(self, _message: &str) -> T = Unwrap;
        fn __b_unwrap_or(self, _other: T) -> T = UnwrapOr: Option(OptionMethod::UnwrapOr);
        fn __b_or(self, _other: Option<T>) -> Option<T> = Or: Option(OptionMethod::Or);
        fn __b_and[U](self, _other: Option<U>) -> Option<U> = And: Option(OptionMethod::And);
        fn __b_take(&mut self) -> Option<T> = Take: Option(OptionMethod::Take);
        fn __b_replace(&mut self, _value: T) -> Option<T> = Replace: Option(OptionMethod::Replace);
        fn __b_ok_or[E](self, _error: E) -> Result<T, E> = OkOr: Option(OptionMethod::OkOr);
        fn __b_as_ref(&self) -> Option<&T> = AsRef: Desugared(Desugared::AsRef);
        fn __b_as_mut(&mut self) -> Option<&mut T> = AsMut: Option(OptionMethod::AsMut);
        fn __b_insert(&mut self, _value: T) -> &mut T = Insert: Option(OptionMethod::Insert);
        fn __b_get_or_insert(&mut self, _value: T) -> &mut T = GetOrInsert: Option(OptionMethod::GetOrInsert);
        fn __b_get_or_insert_with(&mut self, _f: impl FnOnce() -> T) -> &mut T
            = GetOrInsertWith: Option(OptionMethod::GetOrInsertWith);
    }
    /// `copied` of an `Option` of a reference.
    impl[T] CopiedBuiltin<T> for Option<&T> {
        fn __b_copied(self) -> Option<T> = Copied: Option(OptionMethod::Copied);
        fn __b_cloned(self) -> Option<T> = Copied;
    }
    /// `map` of an array.
    impl[T, const N: usize] ArrayBuiltins<T, N> for [T; N] {
        fn __b_map[U](self, _f: impl FnMut(T) -> U) -> [U; N] = ArrayMap: Desugared(Desugared::ArrayMap);
    }
    /// Methods of `Result`.
    impl[T, E] ResultBuiltins<T, E> for Result<T, E> {
        fn __b_unwrap(self) -> T = Unwrap;
        fn __b_expect(self, _message: &str) -> T = Unwrap;
        fn __b_unwrap_err(self) -> E = UnwrapErr: Option(OptionMethod::UnwrapErr);
        fn __b_expect_err(self, _message: &str) -> E = UnwrapErr;
        fn __b_unwrap_or(self, _other: T) -> T = UnwrapOr;
        fn __b_ok(self) -> Option<T> = Ok: Option(OptionMethod::Ok);
        fn __b_err(self) -> Option<E> = Err: Option(OptionMethod::Err);
        fn __b_or(self, _other: Result<T, E>) -> Result<T, E> = Or;
        fn __b_and[U](self, _other: Result<U, E>) -> Result<U, E> = And;
        fn __b_as_ref(&self) -> Result<&T, &E> = AsRef;
    }
    /// Companion of the mutable reborrow of an option's payload.
    impl[T: ?Sized] LentOnBuiltin<T> for Option<&mut T> {
        fn __b_as_deref_mut(&mut self) -> Option<&mut T> = [AsRef];
        fn __b_as_deref(&self) -> Option<&T> = [optional::as_deref];
    }
    /// Companion of the shared reborrow of an option's payload.
    impl[T: ?Sized] ReadOnBuiltin<T> for Option<&T> {
        fn __b_as_deref(&self) -> Option<&T> = [AsRef];
    }
    /// Methods of names.
    pub trait NameBuiltins {
        fn __b_is_empty(&self) -> bool = [name::is_empty];
    }
    /// Methods of lists.
    impl[T, const N: usize] ListBuiltins<T, N> for List<T, N> {
        fn __b_new() -> Self = New: List(ListMethod::New);
        fn __b_push(&mut self, _element: T) -> () = Push: List(ListMethod::Push);
        fn __b_pop(&mut self) -> Option<T> = Pop: List(ListMethod::Pop);
        fn __b_clear(&mut self) -> () = Clear: List(ListMethod::Clear);
        fn __b_truncate(&mut self, _length: usize) -> () = Truncate: List(ListMethod::Truncate);
        fn __b_resize(&mut self, _length: usize, _element: T) -> () = Resize: List(ListMethod::Resize);
        fn __b_len(&self) -> usize = Len: List(ListMethod::Len);
        fn __b_is_empty(&self) -> bool = IsEmpty: List(ListMethod::IsEmpty);
        fn __b_capacity(&self) -> usize = Capacity: List(ListMethod::Capacity);
    }
    /// Companion of `list.extend(items)` with items of type `E`: elements, or references to them.
    pub trait ListExtends[E]: Sized {
        /// Marker of the function.
        type Marker;
        fn __b_extend[I: IntoIterator<Item = E>](&mut self, _items: I) -> () = [Self::Marker];
    }
    /// Methods of inclusive ranges.
    impl[T: Value + Copy] ClosedBuiltins<T> for RangeInclusive<T> {
        fn __b_new(_start: T, _end: T) -> Self = [range::__function_closed<T>];
        fn __b_start(&self) -> &T = [range::__function_start<T>];
        fn __b_end(&self) -> &T = [range::__function_end<T>];
    }
    /// Companions of ranges that include their end.
    impl[T: Value + Copy + PartialOrd] ClosedContents<T> for RangeInclusive<T> {
        fn __b_contains(&self, _number: &T) -> bool = [range::__function_closed_contains<T>];
        fn __b_is_empty(&self) -> bool = [range::__function_closed_is_empty<T>];
    }
    /// Companions of ranges that exclude their end.
    impl[T: Value + Copy + PartialOrd] Contents<T> for Range<T> {
        fn __b_contains(&self, _number: &T) -> bool = [range::__function_contains<T>];
        fn __b_is_empty(&self) -> bool = [range::__function_is_empty<T>];
    }
    /// Companion of a range's number of elements.
    pub trait RangeLength: Sized {
        /// Marker of the function.
        type Marker;
        fn __b_len(&self) -> usize = [Self::Marker];
    }
    /// Methods of integers that are not zero.
    pub trait NonZeroBuiltins[T]: Sized {
        fn __b_new(_value: T) -> Option<Self> = [non_zero::__function_new<T>];
        fn __b_get(self) -> T = [non_zero::__function_get<T>];
    }
}

impl NameBuiltins for str {}

impl<T: Value + Copy + Default, const N: usize> ListExtends<T> for List<T, N> {
    type Marker = list_edit::__function_extend<T, N>;
}

impl<T: Value + Copy + Default, const N: usize> ListExtends<&T> for List<T, N> {
    type Marker = list_edit::__function_extend_by<T, N>;
}

macro_rules! lengths {
    ($($int:ident: $length:ident,)*) => {$(
        impl RangeLength for Range<$int> {
            type Marker = range::$length;
        }
    )*};
}

lengths! {
    u8: len_u8,
    u16: len_u16,
    u32: len_u32,
    usize: len_usize,
    i8: len_i8,
    i16: len_i16,
    i32: len_i32,
    isize: len_isize,
}

macro_rules! integers {
    ($($int:ident)*) => {$(
        stands! { [] NonZero<$int> => non_zero::NonZero<$int>; }
        impl NonZeroBuiltins<$int> for NonZero<$int> {}
        converts! { [] NonZero<$int> => $int: non_zero::__function_get<$int>; }
    )*};
}

integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }

/// Carriers of functions of `core::array`.
#[allow(non_camel_case_types)]
pub mod array {
    pub struct from_fn;
}

/// Carriers of functions of `core::mem`, whose values need not be `Copy`.
#[allow(non_camel_case_types)]
pub mod mem {
    pub struct swap;
    pub struct replace;

    /// Marker without a value, since core has a function of this name.
    pub struct drop {}
}

calls! {
    array::from_fn[T, const N: usize, F: FnMut(usize) -> T](_f: F) -> [T; N] = ArrayFromFn: Desugared(Desugared::FromFn);
    mem::drop[T](_value: T) -> () = [exchange::drop];
    mem::swap[T](_one: &mut T, _other: &mut T) -> () = [exchange::swap];
    mem::replace[T](_place: &mut T, _value: T) -> T = [exchange::replace];
}
