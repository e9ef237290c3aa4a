//! The companions of the methods of `Option`, `Result` and `bool`.

use bessemer_ir::tree::{self, Desugared, OptionMethod};

use super::builder::{Builder, Callee};
use super::builtin::{markers, operations, signatures};
use super::slot::Called;
use crate::{optional, outcome};

markers! {
    Copied: Option(OptionMethod::Copied);
    ArrayMap: Desugared(Desugared::ArrayMap);
}

operations! {
    /// Methods of `Option`.
    pub trait OptionBuiltins<T>: Sized {
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
        fn __b_xor(self, _other: Option<T>) -> Option<T> = [optional::xor];
        fn __b_zip[U](self, _other: Option<U>) -> Option<(T, U)> = [optional::zip];
        fn __b_map[U](self, _f: impl FnOnce(T) -> U) -> Option<U> = [optional::map];
        fn __b_and_then[U](self, _f: impl FnOnce(T) -> Option<U>) -> Option<U> = [optional::and_then];
        fn __b_inspect(self, _f: impl FnOnce(&T)) -> Option<T> = [optional::inspect];
        fn __b_filter(self, _f: impl FnOnce(&T) -> bool) -> Option<T> = [optional::filter];
        fn __b_or_else(self, _f: impl FnOnce() -> Option<T>) -> Option<T> = [optional::or_else];
        fn __b_unwrap_or_else(self, _f: impl FnOnce() -> T) -> T = [optional::unwrap_or_else];
        fn __b_map_or[U](self, _other: U, _f: impl FnOnce(T) -> U) -> U = [optional::map_or];
        fn __b_map_or_else[U](self, _other: impl FnOnce() -> U, _f: impl FnOnce(T) -> U) -> U
            = [optional::map_or_else];
        fn __b_is_some_and(self, _f: impl FnOnce(T) -> bool) -> bool = [optional::is_some_and];
        fn __b_is_none_or(self, _f: impl FnOnce(T) -> bool) -> bool = [optional::is_none_or];
        fn __b_ok_or_else[E](self, _f: impl FnOnce() -> E) -> Result<T, E> = [optional::ok_or_else];
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
    CopiedBuiltin[T] for Option<&T> {
        fn __b_copied(self) -> Called<Copied, Option<T>>;
        fn __b_cloned(self) -> Called<Copied, Option<T>>;
    }
    /// The same of a reference that may be written through.
    CopiedMutBuiltin[T] for Option<&mut T> {
        fn __b_copied(self) -> Called<optional::copied, Option<T>>;
        fn __b_cloned(self) -> Called<optional::copied, Option<T>>;
    }
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

/// What lends on what an `Option` refers to: the same reference, or one that only reads.
#[allow(missing_docs)]
pub trait LentOnBuiltin<T: ?Sized>: Sized {
    signatures! {
        fn __b_as_deref_mut(&mut self) -> Called<AsRef, Option<&mut T>>;
        fn __b_as_deref(&self) -> Called<optional::as_deref, Option<&T>>;
    }
}

impl<T: ?Sized> LentOnBuiltin<T> for Option<&mut T> {}

/// The same of what is only read.
#[allow(missing_docs)]
pub trait ReadOnBuiltin<T: ?Sized>: Sized {
    signatures! { fn __b_as_deref(&self) -> Called<AsRef, Option<&T>>; }
}

impl<T: ?Sized> ReadOnBuiltin<T> for Option<&T> {}

/// The companions of functions of `core::mem`: a value need not be `Copy` there.
#[allow(missing_docs, non_camel_case_types)]
pub mod mem {
    use super::{Called, signatures};
    use crate::exchange;

    pub struct swap;
    pub struct replace;

    /// Of no value: one of its name is core's.
    pub struct drop {}

    impl drop {
        signatures! {
            pub fn __call[T](_value: T) -> Called<exchange::drop, ()>;
        }
    }

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

operations! {
    /// Methods of `Result`.
    pub trait ResultBuiltins<T, E>: Sized {
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
        fn __b_map[U](self, _f: impl FnOnce(T) -> U) -> Result<U, E> = [outcome::map];
        fn __b_map_err[F](self, _f: impl FnOnce(E) -> F) -> Result<T, F> = [outcome::map_err];
        fn __b_and_then[U](self, _f: impl FnOnce(T) -> Result<U, E>) -> Result<U, E> = [outcome::and_then];
        fn __b_inspect(self, _f: impl FnOnce(&T)) -> Result<T, E> = [outcome::inspect];
        fn __b_inspect_err(self, _f: impl FnOnce(&E)) -> Result<T, E> = [outcome::inspect_err];
        fn __b_or_else[F](self, _f: impl FnOnce(E) -> Result<T, F>) -> Result<T, F> = [outcome::or_else];
        fn __b_unwrap_or_else(self, _f: impl FnOnce(E) -> T) -> T = [outcome::unwrap_or_else];
        fn __b_map_or[U](self, _other: U, _f: impl FnOnce(T) -> U) -> U = [outcome::map_or];
        fn __b_map_or_else[U](self, _other: impl FnOnce(E) -> U, _f: impl FnOnce(T) -> U) -> U
            = [outcome::map_or_else];
        fn __b_is_ok_and(self, _f: impl FnOnce(T) -> bool) -> bool = [outcome::is_ok_and];
        fn __b_is_err_and(self, _f: impl FnOnce(E) -> bool) -> bool = [outcome::is_err_and];
    }
}

impl<T, E> ResultBuiltins<T, E> for Result<T, E> {}
