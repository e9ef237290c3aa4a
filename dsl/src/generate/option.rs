//! The companions of the methods of `Option` and `Result`.

use alloc::borrow::ToOwned;

use bessemer_ir::tree;

use super::builtin::markers;
use super::{Builder, Called, Callee};

markers! {
    IsSome: "is_some";
    IsNone: "is_none";
    IsOk: "is_ok";
    IsErr: "is_err";
    Unwrap: "unwrap";
    UnwrapErr: "unwrap_err";
    UnwrapOr: "unwrap_or";
    UnwrapOrDefault: "unwrap_or_default";
    Copied: "copied";
    Or: "or";
    And: "and";
    Take: "take";
    Replace: "replace";
    OkOr: "ok_or";
    Ok: "ok";
    Err: "err";
}

/// Methods of `Option`.
#[allow(missing_docs)]
pub trait OptionBuiltins<T>: Sized {
    fn __b_is_some(&self) -> Called<IsSome, bool> {
        unreachable!()
    }
    fn __b_is_none(&self) -> Called<IsNone, bool> {
        unreachable!()
    }
    fn __b_unwrap(self) -> Called<Unwrap, T> {
        unreachable!()
    }
    fn __b_expect(self, _message: &str) -> Called<Unwrap, T> {
        unreachable!()
    }
    fn __b_unwrap_or(self, _other: T) -> Called<UnwrapOr, T> {
        unreachable!()
    }
    fn __b_unwrap_or_default(self) -> Called<UnwrapOrDefault, T>
    where
        T: Default,
    {
        unreachable!()
    }
    fn __b_or(self, _other: Option<T>) -> Called<Or, Option<T>> {
        unreachable!()
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
}

impl<T> OptionBuiltins<T> for Option<T> {}

/// `copied` of an `Option` of a reference.
pub trait CopiedBuiltin<T>: Sized {
    #[allow(missing_docs)]
    fn __b_copied(self) -> Called<Copied, Option<T>> {
        unreachable!()
    }
}

impl<T> CopiedBuiltin<T> for Option<&T> {}

/// Methods of `Result`.
#[allow(missing_docs)]
pub trait ResultBuiltins<T, E>: Sized {
    fn __b_is_ok(&self) -> Called<IsOk, bool> {
        unreachable!()
    }
    fn __b_is_err(&self) -> Called<IsErr, bool> {
        unreachable!()
    }
    fn __b_unwrap(self) -> Called<Unwrap, T> {
        unreachable!()
    }
    fn __b_expect(self, _message: &str) -> Called<Unwrap, T> {
        unreachable!()
    }
    fn __b_unwrap_err(self) -> Called<UnwrapErr, E> {
        unreachable!()
    }
    fn __b_expect_err(self, _message: &str) -> Called<UnwrapErr, E> {
        unreachable!()
    }
    fn __b_unwrap_or(self, _other: T) -> Called<UnwrapOr, T> {
        unreachable!()
    }
    fn __b_unwrap_or_default(self) -> Called<UnwrapOrDefault, T>
    where
        T: Default,
    {
        unreachable!()
    }
    fn __b_ok(self) -> Called<Ok, Option<T>> {
        unreachable!()
    }
    fn __b_err(self) -> Called<Err, Option<E>> {
        unreachable!()
    }
    fn __b_or(self, _other: Result<T, E>) -> Called<Or, Result<T, E>> {
        unreachable!()
    }
    fn __b_and<U>(self, _other: Result<U, E>) -> Called<And, Result<U, E>> {
        unreachable!()
    }
}

impl<T, E> ResultBuiltins<T, E> for Result<T, E> {}
