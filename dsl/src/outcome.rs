//! Methods of results, in the DSL's own Rust: a call is replaced by the body.
//!
//! Must not know: how any of it becomes C. `optional.rs` has the methods of options.

// They are what they would be written with.
#![allow(clippy::manual_unwrap_or_default, clippy::redundant_pattern_matching)]

use crate::library;

#[library(ResultCompanions, rewrite)]
impl<T, E> Result<T, E> {
    /// Returns true if there is a value.
    pub fn is_ok(result: &Self) -> bool {
        matches!(result, Ok(_))
    }

    /// Returns true if there is an error.
    pub fn is_err(result: &Self) -> bool {
        !matches!(result, Ok(_))
    }

    /// Applies `f` to the value.
    pub fn map<U, F: FnOnce(T) -> U>(result: Self, f: F) -> Result<U, E> {
        match result {
            Ok(value) => Ok(f(value)),
            Err(error) => Err(error),
        }
    }

    /// Applies `f` to the error.
    pub fn map_err<G, F: FnOnce(E) -> G>(result: Self, f: F) -> Result<T, G> {
        match result {
            Ok(value) => Ok(value),
            Err(error) => Err(f(error)),
        }
    }

    /// Calls `f` with a reference to the value, if any.
    pub fn inspect<F: FnOnce(&T)>(result: Self, f: F) -> Self {
        match result {
            Ok(value) => {
                f(&value);
                Ok(value)
            }
            Err(error) => Err(error),
        }
    }

    /// Calls `f` with a reference to the error, if any.
    pub fn inspect_err<F: FnOnce(&E)>(result: Self, f: F) -> Self {
        match result {
            Ok(value) => Ok(value),
            Err(error) => {
                f(&error);
                Err(error)
            }
        }
    }

    /// Applies `f`, which returns a result, to the value.
    pub fn and_then<U, F: FnOnce(T) -> Result<U, E>>(result: Self, f: F) -> Result<U, E> {
        match result {
            Ok(value) => f(value),
            Err(error) => Err(error),
        }
    }

    /// The value, or the result of `f` for the error; `f` returns a result, too.
    pub fn or_else<G, F: FnOnce(E) -> Result<T, G>>(result: Self, f: F) -> Result<T, G> {
        match result {
            Ok(value) => Ok(value),
            Err(error) => f(error),
        }
    }

    /// The value, or the result of `f` for the error.
    pub fn unwrap_or_else<F: FnOnce(E) -> T>(result: Self, f: F) -> T {
        match result {
            Ok(value) => value,
            Err(error) => f(error),
        }
    }

    /// The result of `f` for the value; `other` for an error.
    pub fn map_or<U, F: FnOnce(T) -> U>(result: Self, other: U, f: F) -> U {
        match result {
            Ok(value) => f(value),
            Err(_) => other,
        }
    }

    /// The result of `f` for the value, or of `other` for the error.
    pub fn map_or_else<U, O: FnOnce(E) -> U, F: FnOnce(T) -> U>(result: Self, other: O, f: F) -> U {
        match result {
            Ok(value) => f(value),
            Err(error) => other(error),
        }
    }

    /// Returns true if there is a value that satisfies `f`.
    pub fn is_ok_and<F: FnOnce(T) -> bool>(result: Self, f: F) -> bool
    where
        T: Copy,
    {
        matches!(result, Ok(value) if f(value))
    }

    /// Returns true if there is an error that satisfies `f`.
    pub fn is_err_and<F: FnOnce(E) -> bool>(result: Self, f: F) -> bool
    where
        E: Copy,
    {
        matches!(result, Err(error) if f(error))
    }
}

#[library(ResultDefaultCompanion, expand)]
impl<T: Default, E> Result<T, E> {
    /// The value, or the default of its type.
    pub fn unwrap_or_default(result: Self) -> T {
        match result {
            Ok(value) => value,
            Err(_) => T::default(),
        }
    }
}

#[library(TransposeBackCompanion, rewrite)]
impl<T, E> Result<Option<T>, E> {
    /// An option of a result from a result of an option.
    pub fn transpose(result: Self) -> Option<Result<T, E>> {
        match result {
            Ok(Some(value)) => Some(Ok(value)),
            Ok(None) => None,
            Err(error) => Some(Err(error)),
        }
    }
}
