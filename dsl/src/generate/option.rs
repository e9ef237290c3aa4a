//! The companions of the methods of `Option`, `Result` and `bool`.

use bessemer_ir::tree::{self, Desugared, OptionMethod};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::slot::Called;
use crate::{optional, outcome};

markers! {
    IsSome: Option(OptionMethod::IsSome);
    IsNone: Option(OptionMethod::IsNone);
    IsOk: Option(OptionMethod::IsOk);
    IsErr: Option(OptionMethod::IsErr);
    Unwrap: Option(OptionMethod::Unwrap);
    UnwrapErr: Option(OptionMethod::UnwrapErr);
    UnwrapOr: Option(OptionMethod::UnwrapOr);
    UnwrapOrDefault: Option(OptionMethod::UnwrapOrDefault);
    Copied: Option(OptionMethod::Copied);
    Or: Option(OptionMethod::Or);
    And: Option(OptionMethod::And);
    Take: Option(OptionMethod::Take);
    Replace: Option(OptionMethod::Replace);
    OkOr: Option(OptionMethod::OkOr);
    Ok: Option(OptionMethod::Ok);
    Err: Option(OptionMethod::Err);
    AsRef: Desugared(Desugared::AsRef);
    AsMut: Option(OptionMethod::AsMut);
    Insert: Option(OptionMethod::Insert);
    GetOrInsert: Option(OptionMethod::GetOrInsert);
    GetOrInsertWith: Option(OptionMethod::GetOrInsertWith);
    ArrayMap: Desugared(Desugared::ArrayMap);
}

/// Methods of `Option`.
#[allow(missing_docs)]
pub trait OptionBuiltins<T>: Sized {
    signatures! {
        fn __b_is_some(&self) -> Called<IsSome, bool>;
        fn __b_is_none(&self) -> Called<IsNone, bool>;
        fn __b_unwrap(self) -> Called<Unwrap, T>;
        fn __b_expect(self, _message: &str) -> Called<Unwrap, T>;
        fn __b_unwrap_or(self, _other: T) -> Called<UnwrapOr, T>;
        fn __b_unwrap_or_default(self) -> Called<UnwrapOrDefault, T> where T: Default;
        fn __b_or(self, _other: Option<T>) -> Called<Or, Option<T>>;
        fn __b_and[U](self, _other: Option<U>) -> Called<And, Option<U>>;
        fn __b_take(&mut self) -> Called<Take, Option<T>>;
        fn __b_replace(&mut self, _value: T) -> Called<Replace, Option<T>>;
        fn __b_ok_or[E](self, _error: E) -> Called<OkOr, Result<T, E>>;
        fn __b_as_ref(&self) -> Called<AsRef, Option<&T>>;
        fn __b_as_mut(&mut self) -> Called<AsMut, Option<&mut T>>;
        fn __b_insert(&mut self, _value: T) -> Called<Insert, &mut T>;
        fn __b_get_or_insert(&mut self, _value: T) -> Called<GetOrInsert, &mut T>;
        fn __b_get_or_insert_with(
            &mut self, _f: impl FnOnce() -> T
        ) -> Called<GetOrInsertWith, &mut T>;

        fn __b_xor(self, _other: Option<T>) -> Called<optional::xor, Option<T>>;
        fn __b_zip[U](self, _other: Option<U>) -> Called<optional::zip, Option<(T, U)>>;
        fn __b_map[U](self, _f: impl FnOnce(T) -> U) -> Called<optional::map, Option<U>>;
        fn __b_and_then[U](
            self, _f: impl FnOnce(T) -> Option<U>
        ) -> Called<optional::and_then, Option<U>>;
        fn __b_filter(self, _f: impl FnOnce(&T) -> bool) -> Called<optional::filter, Option<T>>;
        fn __b_or_else(
            self, _f: impl FnOnce() -> Option<T>
        ) -> Called<optional::or_else, Option<T>>;
        fn __b_unwrap_or_else(self, _f: impl FnOnce() -> T) -> Called<optional::unwrap_or_else, T>;
        fn __b_map_or[U](self, _other: U, _f: impl FnOnce(T) -> U) -> Called<optional::map_or, U>;
        fn __b_map_or_else[U](
            self, _other: impl FnOnce() -> U, _f: impl FnOnce(T) -> U
        ) -> Called<optional::map_or_else, U>;
        fn __b_is_some_and(
            self, _f: impl FnOnce(T) -> bool
        ) -> Called<optional::is_some_and, bool>;
        fn __b_is_none_or(self, _f: impl FnOnce(T) -> bool) -> Called<optional::is_none_or, bool>;
        fn __b_ok_or_else[E](
            self, _f: impl FnOnce() -> E
        ) -> Called<optional::ok_or_else, Result<T, E>>;
    }
}

impl<T> OptionBuiltins<T> for Option<T> {}

/// Methods of `bool`.
#[allow(missing_docs)]
pub trait BoolBuiltins: Sized {
    signatures! {
        fn __b_then[T](self, _value: impl FnOnce() -> T) -> Called<optional::then, Option<T>>;
        fn __b_then_some[T](self, _value: T) -> Called<optional::then_some, Option<T>>;
    }
}

impl BoolBuiltins for bool {}

/// Methods of an `Option` of a type of some kind.
macro_rules! of_options {
    ($(
        $(#[$doc:meta])*
        $trait:ident[$($g:ident),*] for $ty:ty { $($companion:tt)* }
    )*) => {$(
        $(#[$doc])*
        #[allow(missing_docs)]
        pub trait $trait<$($g),*>: Sized {
            signatures! { $($companion)* }
        }

        impl<$($g),*> $trait<$($g),*> for $ty {}
    )*};
}

of_options! {
    /// `copied` of an `Option` of a reference.
    CopiedBuiltin[T] for Option<&T> { fn __b_copied(self) -> Called<Copied, Option<T>>; }
    /// `flatten` of an `Option` in an `Option`.
    FlattenBuiltin[T] for Option<Option<T>> {
        fn __b_flatten(self) -> Called<optional::flatten, Option<T>>;
    }
    /// `transpose` of an `Option` of a `Result`.
    TransposeBuiltin[T, E] for Option<Result<T, E>> {
        fn __b_transpose(self) -> Called<optional::transpose, Result<Option<T>, E>>;
    }
    /// `transpose` of a `Result` of an `Option`.
    TransposeBackBuiltin[T, E] for Result<Option<T>, E> {
        fn __b_transpose(self) -> Called<outcome::transpose, Option<Result<T, E>>>;
    }
    /// `unzip` of an `Option` of a pair.
    UnzipBuiltin[A, B] for Option<(A, B)> {
        fn __b_unzip(self) -> Called<optional::unzip, (Option<A>, Option<B>)>;
    }
}

/// The companions of functions of `core::mem`: a value need not be `Copy` there.
#[allow(missing_docs, non_camel_case_types)]
pub mod mem {
    use super::{Called, signatures};
    use crate::exchange;

    pub struct swap;
    pub struct replace;

    impl swap {
        signatures! {
            pub fn __call[T](_one: &mut T, _other: &mut T) -> Called<exchange::swap, ()>;
        }
    }

    impl replace {
        signatures! {
            pub fn __call[T](_place: &mut T, _value: T) -> Called<exchange::replace, T>;
        }
    }
}

/// `map` of an array.
#[allow(missing_docs)]
pub trait ArrayBuiltins<T, const N: usize>: Sized {
    signatures! { fn __b_map[U](self, _f: impl FnMut(T) -> U) -> Called<ArrayMap, [U; N]>; }
}

impl<T, const N: usize> ArrayBuiltins<T, N> for [T; N] {}

/// Methods of `Result`.
#[allow(missing_docs)]
pub trait ResultBuiltins<T, E>: Sized {
    signatures! {
        fn __b_is_ok(&self) -> Called<IsOk, bool>;
        fn __b_is_err(&self) -> Called<IsErr, bool>;
        fn __b_unwrap(self) -> Called<Unwrap, T>;
        fn __b_expect(self, _message: &str) -> Called<Unwrap, T>;
        fn __b_unwrap_err(self) -> Called<UnwrapErr, E>;
        fn __b_expect_err(self, _message: &str) -> Called<UnwrapErr, E>;
        fn __b_unwrap_or(self, _other: T) -> Called<UnwrapOr, T>;
        fn __b_unwrap_or_default(self) -> Called<UnwrapOrDefault, T> where T: Default;
        fn __b_ok(self) -> Called<Ok, Option<T>>;
        fn __b_err(self) -> Called<Err, Option<E>>;
        fn __b_or(self, _other: Result<T, E>) -> Called<Or, Result<T, E>>;
        fn __b_and[U](self, _other: Result<U, E>) -> Called<And, Result<U, E>>;
        fn __b_as_ref(&self) -> Called<AsRef, Result<&T, &E>>;

        fn __b_map[U](self, _f: impl FnOnce(T) -> U) -> Called<outcome::map, Result<U, E>>;
        fn __b_map_err[F](self, _f: impl FnOnce(E) -> F) -> Called<outcome::map_err, Result<T, F>>;
        fn __b_and_then[U](
            self, _f: impl FnOnce(T) -> Result<U, E>
        ) -> Called<outcome::and_then, Result<U, E>>;
        fn __b_or_else[F](
            self, _f: impl FnOnce(E) -> Result<T, F>
        ) -> Called<outcome::or_else, Result<T, F>>;
        fn __b_unwrap_or_else(self, _f: impl FnOnce(E) -> T) -> Called<outcome::unwrap_or_else, T>;
        fn __b_map_or[U](self, _other: U, _f: impl FnOnce(T) -> U) -> Called<outcome::map_or, U>;
        fn __b_map_or_else[U](
            self, _other: impl FnOnce(E) -> U, _f: impl FnOnce(T) -> U
        ) -> Called<outcome::map_or_else, U>;
        fn __b_is_ok_and(self, _f: impl FnOnce(T) -> bool) -> Called<outcome::is_ok_and, bool>;
        fn __b_is_err_and(self, _f: impl FnOnce(E) -> bool) -> Called<outcome::is_err_and, bool>;
    }
}

impl<T, E> ResultBuiltins<T, E> for Result<T, E> {}
