//! A case.
#![no_std]
use bessemer::prelude::*;

/// A method that the DSL owns, of a type for which it has none.
#[function]
pub fn caller(z: &SVector<i32, 3>) -> SVector<i32, 3> {
    z.abs()
}
