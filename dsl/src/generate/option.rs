//! The companions of the methods of `Option`, `Result` and `bool`.

use bessemer_ir::tree::{self, CaseMethod, Cases, Desugared, OptionMethod};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::matrices::told;
use super::slot::{Called, Value};
use crate::optional;

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
    Xor: Desugared(Desugared::OptionXor);
    Zip: Desugared(Desugared::OptionZip);
    Insert: Option(OptionMethod::Insert);
    GetOrInsert: Option(OptionMethod::GetOrInsert);
    GetOrInsertWith: Option(OptionMethod::GetOrInsertWith);
    Flatten: Desugared(Desugared::Case(Cases::Option, CaseMethod::Flatten));
    Map: Desugared(Desugared::Case(Cases::Option, CaseMethod::Map));
    AndThen: Desugared(Desugared::Case(Cases::Option, CaseMethod::AndThen));
    Filter: Desugared(Desugared::Case(Cases::Option, CaseMethod::Filter));
    OrElse: Desugared(Desugared::Case(Cases::Option, CaseMethod::OrElse));
    UnwrapOrElse: Desugared(Desugared::Case(Cases::Option, CaseMethod::UnwrapOrElse));
    MapOr: Desugared(Desugared::Case(Cases::Option, CaseMethod::MapOr));
    MapOrElse: Desugared(Desugared::Case(Cases::Option, CaseMethod::MapOrElse));
    IsSomeAnd: Desugared(Desugared::Case(Cases::Option, CaseMethod::IsAnd));
    IsNoneOr: Desugared(Desugared::Case(Cases::Option, CaseMethod::IsNoneOr));
    OkOrElse: Desugared(Desugared::Case(Cases::Option, CaseMethod::OkOrElse));
    ResultMap: Desugared(Desugared::Case(Cases::Result, CaseMethod::Map));
    ResultMapErr: Desugared(Desugared::Case(Cases::Result, CaseMethod::MapErr));
    ResultAndThen: Desugared(Desugared::Case(Cases::Result, CaseMethod::AndThen));
    ResultOrElse: Desugared(Desugared::Case(Cases::Result, CaseMethod::OrElse));
    ResultUnwrapOrElse: Desugared(Desugared::Case(Cases::Result, CaseMethod::UnwrapOrElse));
    ResultMapOr: Desugared(Desugared::Case(Cases::Result, CaseMethod::MapOr));
    ResultMapOrElse: Desugared(Desugared::Case(Cases::Result, CaseMethod::MapOrElse));
    IsOkAnd: Desugared(Desugared::Case(Cases::Result, CaseMethod::IsAnd));
    IsErrAnd: Desugared(Desugared::Case(Cases::Result, CaseMethod::IsErrAnd));
    ArrayMap: Desugared(Desugared::ArrayMap);
    Then: Desugared(Desugared::BoolThen);
    ThenSome: Desugared(Desugared::BoolThenSome);
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
    }
    fn __b_and<U>(self, _other: Option<U>) -> Called<And, Option<U>> {
        unreachable!()
    }
    fn __b_take(&mut self) -> Called<Take, Option<T>> {
        unreachable!()
    }
    fn __b_replace(&mut self, _value: T) -> Called<Replace, Option<T>> {
        unreachable!()
    }
    fn __b_ok_or<E>(self, _error: E) -> Called<OkOr, Result<T, E>> {
        unreachable!()
    }
    signatures! {
        fn __b_as_ref(&self) -> Called<AsRef, Option<&T>>;
        fn __b_as_mut(&mut self) -> Called<AsMut, Option<&mut T>>;
        fn __b_xor(self, _other: Option<T>) -> Called<Xor, Option<T>>;
    }
    fn __b_zip<U>(self, _other: Option<U>) -> Called<Zip, Option<(T, U)>> {
        unreachable!()
    }
    signatures! {
        fn __b_insert(&mut self, _value: T) -> Called<Insert, &mut T>;
        fn __b_get_or_insert(&mut self, _value: T) -> Called<GetOrInsert, &mut T>;
        fn __b_get_or_insert_with(
            &mut self, _f: impl FnOnce() -> T
        ) -> Called<GetOrInsertWith, &mut T>;
    }
    fn __b_map<U>(self, _f: impl FnOnce(T) -> U) -> Called<Map, Option<U>> {
        unreachable!()
    }
    fn __b_and_then<U>(self, _f: impl FnOnce(T) -> Option<U>) -> Called<AndThen, Option<U>> {
        unreachable!()
    }
    signatures! {
        fn __b_filter(self, _f: impl FnOnce(&T) -> bool) -> Called<Filter, Option<T>>;
        fn __b_or_else(self, _f: impl FnOnce() -> Option<T>) -> Called<OrElse, Option<T>>;
        fn __b_unwrap_or_else(self, _f: impl FnOnce() -> T) -> Called<UnwrapOrElse, T>;
    }
    fn __b_map_or<U>(self, _other: U, _f: impl FnOnce(T) -> U) -> Called<MapOr, U> {
        unreachable!()
    }
    fn __b_map_or_else<U>(
        self,
        _other: impl FnOnce() -> U,
        _f: impl FnOnce(T) -> U,
    ) -> Called<MapOrElse, U> {
        unreachable!()
    }
    fn __b_is_some_and(self, _f: impl FnOnce(T) -> bool) -> Called<IsSomeAnd, bool> {
        unreachable!()
    }
    fn __b_is_none_or(self, _f: impl FnOnce(T) -> bool) -> Called<IsNoneOr, bool> {
        unreachable!()
    }
    fn __b_ok_or_else<E>(self, _f: impl FnOnce() -> E) -> Called<OkOrElse, Result<T, E>> {
        unreachable!()
    }
}

impl<T> OptionBuiltins<T> for Option<T> {}

/// Methods of `bool`.
#[allow(missing_docs)]
pub trait BoolBuiltins: Sized {
    fn __b_then<T>(self, _value: impl FnOnce() -> T) -> Called<Then, Option<T>> {
        unreachable!()
    }
    fn __b_then_some<T>(self, _value: T) -> Called<ThenSome, Option<T>> {
        unreachable!()
    }
}

impl BoolBuiltins for bool {}

/// `copied` of an `Option` of a reference.
pub trait CopiedBuiltin<T>: Sized {
    #[allow(missing_docs)]
    fn __b_copied(self) -> Called<Copied, Option<T>> {
        unreachable!()
    }
}

impl<T> CopiedBuiltin<T> for Option<&T> {}

/// `flatten` of an `Option` in an `Option`.
pub trait FlattenBuiltin<T>: Sized {
    #[allow(missing_docs)]
    fn __b_flatten(self) -> Called<Flatten, Option<T>> {
        unreachable!()
    }
}

impl<T> FlattenBuiltin<T> for Option<Option<T>> {}

/// `transpose` of an `Option` of a `Result`.
#[allow(missing_docs)]
pub trait TransposeBuiltin<T, E>: Sized {
    fn __b_transpose(self) -> told!([Self, T, E] => Result<Option<T>, E>);
}

impl<T: Value, E: Value> TransposeBuiltin<T, E> for Option<Result<T, E>> {
    fn __b_transpose(self) -> told!([T, E] => Result<Option<T>, E>) {
        optional::transposed::__call(self)
    }
}

/// `transpose` of a `Result` of an `Option`.
#[allow(missing_docs)]
pub trait TransposeBackBuiltin<T, E>: Sized {
    fn __b_transpose(self) -> told!([Self, T, E] => Option<Result<T, E>>);
}

impl<T: Value, E: Value> TransposeBackBuiltin<T, E> for Result<Option<T>, E> {
    fn __b_transpose(self) -> told!([T, E] => Option<Result<T, E>>) {
        optional::transposed_back::__call(self)
    }
}

/// `unzip` of an `Option` of a pair.
#[allow(missing_docs)]
pub trait UnzipBuiltin<A, B>: Sized {
    fn __b_unzip(self) -> told!([Self, A, B] => (Option<A>, Option<B>));
}

impl<A: Value, B: Value> UnzipBuiltin<A, B> for Option<(A, B)> {
    fn __b_unzip(self) -> told!([A, B] => (Option<A>, Option<B>)) {
        optional::unzipped::__call(self)
    }
}

/// `map` of an array.
pub trait ArrayBuiltins<T, const N: usize>: Sized {
    #[allow(missing_docs)]
    fn __b_map<U>(self, _f: impl FnMut(T) -> U) -> Called<ArrayMap, [U; N]> {
        unreachable!()
    }
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
        fn __b_as_ref(&self) -> Called<AsRef, Result<&T, &E>>;
    }
    fn __b_map<U>(self, _f: impl FnOnce(T) -> U) -> Called<ResultMap, Result<U, E>> {
        unreachable!()
    }
    fn __b_map_err<F>(self, _f: impl FnOnce(E) -> F) -> Called<ResultMapErr, Result<T, F>> {
        unreachable!()
    }
    fn __b_and_then<U>(
        self,
        _f: impl FnOnce(T) -> Result<U, E>,
    ) -> Called<ResultAndThen, Result<U, E>> {
        unreachable!()
    }
    fn __b_or_else<F>(
        self,
        _f: impl FnOnce(E) -> Result<T, F>,
    ) -> Called<ResultOrElse, Result<T, F>> {
        unreachable!()
    }
    fn __b_unwrap_or_else(self, _f: impl FnOnce(E) -> T) -> Called<ResultUnwrapOrElse, T> {
        unreachable!()
    }
    fn __b_map_or<U>(self, _other: U, _f: impl FnOnce(T) -> U) -> Called<ResultMapOr, U> {
        unreachable!()
    }
    fn __b_map_or_else<U>(
        self,
        _other: impl FnOnce(E) -> U,
        _f: impl FnOnce(T) -> U,
    ) -> Called<ResultMapOrElse, U> {
        unreachable!()
    }
    fn __b_is_ok_and(self, _f: impl FnOnce(T) -> bool) -> Called<IsOkAnd, bool> {
        unreachable!()
    }
    fn __b_is_err_and(self, _f: impl FnOnce(E) -> bool) -> Called<IsErrAnd, bool> {
        unreachable!()
    }
    fn __b_and<U>(self, _other: Result<U, E>) -> Called<And, Result<U, E>> {
        unreachable!()
    }
}

impl<T, E> ResultBuiltins<T, E> for Result<T, E> {}
