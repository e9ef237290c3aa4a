//! The companions of the methods of `Option`, `Result` and `bool` that are none of the library's.

#![allow(missing_docs)]

use bessemer_ir::tree::{self, Desugared, OptionMethod};

use super::builder::{Builder, Callee};
use super::builtin::{calls, companions};
use super::slot::Called;
use crate::{exchange, optional};

companions! {
    /// Methods of `Option`.
    impl[T] OptionBuiltins<T> for Option<T> {
        fn __b_is_some(&self) -> bool = IsSome: Option(OptionMethod::IsSome);
        fn __b_is_none(&self) -> bool = IsNone: Option(OptionMethod::IsNone);
        fn __b_unwrap(self) -> T = Unwrap: Option(OptionMethod::Unwrap);
        fn __b_expect(self, _message: &str) -> T = Unwrap;
        fn __b_unwrap_or(self, _other: T) -> T = UnwrapOr: Option(OptionMethod::UnwrapOr);
        fn __b_unwrap_or_default(self) -> T where T: Default
            = UnwrapOrDefault: Option(OptionMethod::UnwrapOrDefault);
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
        fn __b_is_ok(&self) -> bool = IsOk: Option(OptionMethod::IsOk);
        fn __b_is_err(&self) -> bool = IsErr: Option(OptionMethod::IsErr);
        fn __b_unwrap(self) -> T = Unwrap;
        fn __b_expect(self, _message: &str) -> T = Unwrap;
        fn __b_unwrap_err(self) -> E = UnwrapErr: Option(OptionMethod::UnwrapErr);
        fn __b_expect_err(self, _message: &str) -> E = UnwrapErr;
        fn __b_unwrap_or(self, _other: T) -> T = UnwrapOr;
        fn __b_unwrap_or_default(self) -> T where T: Default = UnwrapOrDefault;
        fn __b_ok(self) -> Option<T> = Ok: Option(OptionMethod::Ok);
        fn __b_err(self) -> Option<E> = Err: Option(OptionMethod::Err);
        fn __b_or(self, _other: Result<T, E>) -> Result<T, E> = Or;
        fn __b_and[U](self, _other: Result<U, E>) -> Result<U, E> = And;
        fn __b_as_ref(&self) -> Result<&T, &E> = AsRef;
    }
    /// What lends on what an `Option` refers to: the same reference, or one that only reads.
    impl[T: ?Sized] LentOnBuiltin<T> for Option<&mut T> {
        fn __b_as_deref_mut(&mut self) -> Option<&mut T> = [AsRef];
        fn __b_as_deref(&self) -> Option<&T> = [optional::as_deref];
    }
    /// The same of what is only read.
    impl[T: ?Sized] ReadOnBuiltin<T> for Option<&T> {
        fn __b_as_deref(&self) -> Option<&T> = [AsRef];
    }
}

/// The carriers of functions of `core::mem`: a value need not be `Copy` there.
#[allow(non_camel_case_types)]
pub mod mem {
    pub struct swap;
    pub struct replace;

    /// Of no value: one of its name is core's.
    pub struct drop {}
}

calls! {
    mem::drop[T](_value: T) -> () = exchange::drop;
    mem::swap[T](_one: &mut T, _other: &mut T) -> () = exchange::swap;
    mem::replace[T](_place: &mut T, _value: T) -> T = exchange::replace;
}
