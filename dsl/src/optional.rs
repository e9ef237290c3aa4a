//! Methods of options and results that are functions of the DSL in the C, put where they are called.

use crate::function;

/// The option in a result, outside.
#[function(expand)]
pub fn transposed<T, E>(it: Option<Result<T, E>>) -> Result<Option<T>, E> {
    match it {
        Some(Ok(value)) => Ok(Some(value)),
        Some(Err(error)) => Err(error),
        None => Ok(None),
    }
}

/// The result in an option, outside.
#[function(expand)]
pub fn transposed_back<T, E>(it: Result<Option<T>, E>) -> Option<Result<T, E>> {
    match it {
        Ok(Some(value)) => Some(Ok(value)),
        Ok(None) => None,
        Err(error) => Some(Err(error)),
    }
}

/// The parts, each by itself.
#[function(expand)]
pub fn unzipped<A, B>(it: Option<(A, B)>) -> (Option<A>, Option<B>) {
    match it {
        Some((one, other)) => (Some(one), Some(other)),
        None => (None, None),
    }
}
