//! Methods of results, in the DSL's own Rust: a call stands for the body.
//!
//! Must not know: how any of it becomes C. Of an option of the same name: `optional.rs`.

use crate::function;

/// The value of `f` for the value.
#[function(rewrite)]
pub fn map<T, E, U, F: FnOnce(T) -> U>(result: Result<T, E>, f: F) -> Result<U, E> {
    match result {
        Ok(value) => Ok(f(value)),
        Err(error) => Err(error),
    }
}

/// The value of `f` for the error.
#[function(rewrite)]
pub fn map_err<T, E, G, F: FnOnce(E) -> G>(result: Result<T, E>, f: F) -> Result<T, G> {
    match result {
        Ok(value) => Ok(value),
        Err(error) => Err(f(error)),
    }
}

/// Shows the value to `f`.
#[function(rewrite)]
pub fn inspect<T, E, F: FnOnce(&T)>(result: Result<T, E>, f: F) -> Result<T, E> {
    match result {
        Ok(value) => {
            f(&value);
            Ok(value)
        }
        Err(error) => Err(error),
    }
}

/// Shows the error to `f`.
#[function(rewrite)]
pub fn inspect_err<T, E, F: FnOnce(&E)>(result: Result<T, E>, f: F) -> Result<T, E> {
    match result {
        Ok(value) => Ok(value),
        Err(error) => {
            f(&error);
            Err(error)
        }
    }
}

/// What `f` gives for the value.
#[function(rewrite)]
pub fn and_then<T, E, U, F: FnOnce(T) -> Result<U, E>>(result: Result<T, E>, f: F) -> Result<U, E> {
    match result {
        Ok(value) => f(value),
        Err(error) => Err(error),
    }
}

/// The value, else what `f` gives for the error.
#[function(rewrite)]
pub fn or_else<T, E, G, F: FnOnce(E) -> Result<T, G>>(result: Result<T, E>, f: F) -> Result<T, G> {
    match result {
        Ok(value) => Ok(value),
        Err(error) => f(error),
    }
}

/// The value, else that of `f` for the error.
#[function(rewrite)]
pub fn unwrap_or_else<T, E, F: FnOnce(E) -> T>(result: Result<T, E>, f: F) -> T {
    match result {
        Ok(value) => value,
        Err(error) => f(error),
    }
}

/// The value of `f` for the value, else another.
#[function(rewrite)]
pub fn map_or<T, E, U, F: FnOnce(T) -> U>(result: Result<T, E>, other: U, f: F) -> U {
    match result {
        Ok(value) => f(value),
        Err(_) => other,
    }
}

/// The value of `f` for the value, else that of `other` for the error.
#[function(rewrite)]
pub fn map_or_else<T, E, U, O: FnOnce(E) -> U, F: FnOnce(T) -> U>(
    result: Result<T, E>,
    other: O,
    f: F,
) -> U {
    match result {
        Ok(value) => f(value),
        Err(error) => other(error),
    }
}

/// Whether there is a value of which `f` says yes.
#[function(rewrite)]
pub fn is_ok_and<T: Copy, E, F: FnOnce(T) -> bool>(result: Result<T, E>, f: F) -> bool {
    matches!(result, Ok(value) if f(value))
}

/// Whether there is an error of which `f` says yes.
#[function(rewrite)]
pub fn is_err_and<T, E: Copy, F: FnOnce(E) -> bool>(result: Result<T, E>, f: F) -> bool {
    matches!(result, Err(error) if f(error))
}

/// The result in an option, outside.
#[function(rewrite)]
pub fn transpose<T, E>(result: Result<Option<T>, E>) -> Option<Result<T, E>> {
    match result {
        Ok(Some(value)) => Some(Ok(value)),
        Ok(None) => None,
        Err(error) => Some(Err(error)),
    }
}
