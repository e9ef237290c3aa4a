//! Methods of options, and methods of `bool` that return one, in the DSL's own Rust: a call is replaced by the body.
//!
//! Must not know: how any of it becomes C. `outcome.rs` has the methods of results.

// They are what they would be written with.
#![allow(clippy::manual_map, clippy::manual_unwrap_or_default, clippy::redundant_pattern_matching)]

use crate::{function, library};

#[library(OptionCompanions, rewrite)]
impl<T> Option<T> {
    /// Returns true if the option is not empty.
    pub fn is_some(option: &Self) -> bool {
        matches!(option, Some(_))
    }

    /// Returns true if the option is empty.
    pub fn is_none(option: &Self) -> bool {
        !matches!(option, Some(_))
    }

    /// Applies `f` to the content.
    pub fn map<U, F: FnOnce(T) -> U>(option: Self, f: F) -> Option<U> {
        match option {
            Some(value) => Some(f(value)),
            None => None,
        }
    }

    /// Applies `f`, which returns an option, to the content.
    pub fn and_then<U, F: FnOnce(T) -> Option<U>>(option: Self, f: F) -> Option<U> {
        match option {
            Some(value) => f(value),
            None => None,
        }
    }

    /// The content if it satisfies `f`; otherwise `None`.
    pub fn filter<F: FnOnce(&T) -> bool>(option: Self, f: F) -> Self {
        match option {
            Some(value) if f(&value) => Some(value),
            _ => None,
        }
    }

    /// Calls `f` with a reference to the content, if any.
    pub fn inspect<F: FnOnce(&T)>(option: Self, f: F) -> Self {
        match option {
            Some(value) => {
                f(&value);
                Some(value)
            }
            None => None,
        }
    }

    /// The option, or the result of `f` if it is empty.
    pub fn or_else<F: FnOnce() -> Option<T>>(option: Self, f: F) -> Self {
        match option {
            Some(value) => Some(value),
            None => f(),
        }
    }

    /// The content, or the result of `f`.
    pub fn unwrap_or_else<F: FnOnce() -> T>(option: Self, f: F) -> T {
        match option {
            Some(value) => value,
            None => f(),
        }
    }

    /// The result of `f` for the content; `other` if the option is empty.
    pub fn map_or<U, F: FnOnce(T) -> U>(option: Self, other: U, f: F) -> U {
        match option {
            Some(value) => f(value),
            None => other,
        }
    }

    /// The result of `f` for the content; the result of `other` if the option is empty.
    pub fn map_or_else<U, O: FnOnce() -> U, F: FnOnce(T) -> U>(option: Self, other: O, f: F) -> U {
        match option {
            Some(value) => f(value),
            None => other(),
        }
    }

    /// Returns true if there is content that satisfies `f`.
    pub fn is_some_and<F: FnOnce(T) -> bool>(option: Self, f: F) -> bool
    where
        T: Copy,
    {
        matches!(option, Some(value) if f(value))
    }

    /// Returns true if the option is empty or its content satisfies `f`.
    pub fn is_none_or<F: FnOnce(T) -> bool>(option: Self, f: F) -> bool {
        match option {
            Some(value) => f(value),
            None => true,
        }
    }

    /// The content, or the error that `f` returns.
    pub fn ok_or_else<E, F: FnOnce() -> E>(option: Self, f: F) -> Result<T, E> {
        match option {
            Some(value) => Ok(value),
            None => Err(f()),
        }
    }

    /// The option that is not empty, if exactly one of the two is not.
    pub fn xor(one: Self, other: Self) -> Self {
        match (one, other) {
            (Some(value), None) => Some(value),
            (None, Some(value)) => Some(value),
            _ => None,
        }
    }

    /// The content as a pair, if neither option is empty.
    pub fn zip<U>(one: Self, other: Option<U>) -> Option<(T, U)> {
        match (one, other) {
            (Some(first), Some(second)) => Some((first, second)),
            _ => None,
        }
    }
}

#[library(OptionDefaultCompanion, expand)]
impl<T: Default> Option<T> {
    /// The content, or the default of its type.
    pub fn unwrap_or_default(option: Self) -> T {
        match option {
            Some(value) => value,
            None => T::default(),
        }
    }
}

#[library(CopiedMutCompanions, rewrite)]
impl<T> Option<&mut T> {
    /// The option with a copy of the value that the content refers to.
    #[method(copied, cloned)]
    pub fn copied(option: Self) -> Option<T>
    where
        T: Copy,
    {
        match option {
            Some(value) => Some(*value),
            None => None,
        }
    }
}

/// The option with a shared instead of a mutable reference.
#[function(rewrite)]
pub fn as_deref<'a, T: ?Sized>(option: &'a Option<&mut T>) -> Option<&'a T> {
    match option {
        Some(value) => Some(&**value),
        None => None,
    }
}

#[library(FlattenCompanion, rewrite)]
impl<T> Option<Option<T>> {
    /// The inner option; `None` if the outer one is empty.
    pub fn flatten(option: Self) -> Option<T> {
        match option {
            Some(value) => value,
            None => None,
        }
    }
}

#[library(BoolCompanions, rewrite)]
impl bool {
    /// The result of `f` if the condition holds; otherwise `f` is not called.
    pub fn then<T, F: FnOnce() -> T>(condition: Self, f: F) -> Option<T> {
        if condition { Some(f()) } else { None }
    }

    /// A value if the condition holds; the value is computed in either case.
    pub fn then_some<T>(condition: Self, value: T) -> Option<T> {
        if condition { Some(value) } else { None }
    }
}

#[library(TransposeCompanion, rewrite)]
impl<T, E> Option<Result<T, E>> {
    /// A result of an option from an option of a result.
    pub fn transpose(option: Self) -> Result<Option<T>, E> {
        match option {
            Some(Ok(value)) => Ok(Some(value)),
            Some(Err(error)) => Err(error),
            None => Ok(None),
        }
    }
}

#[library(UnzipCompanion, rewrite)]
impl<A, B> Option<(A, B)> {
    /// An option for each part of an optional pair.
    pub fn unzip(option: Self) -> (Option<A>, Option<B>) {
        match option {
            Some((one, other)) => (Some(one), Some(other)),
            None => (None, None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_referred_to_is_what_core_gives() {
        for value in [None, Some(0_i16), Some(-7), Some(i16::MAX)] {
            let [mut one, mut other] = [value; 2];
            assert_eq!(copied(one.as_mut()), other.as_mut().copied());
            let (lent, core) = (one.as_mut(), other.as_mut());
            assert_eq!(as_deref(&lent), core.as_deref());
            assert_eq!(as_deref(&one.as_mut().map(|it| &mut *it)), value.as_ref());
        }
    }
}
