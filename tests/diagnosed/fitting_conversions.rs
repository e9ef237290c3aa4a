//! A case.
#![no_std]
use bessemer::prelude::*;

/// A conversion that always fits.
#[function]
pub fn index(letter: u16) -> usize {
    usize::try_from(letter).unwrap_or(0)
}
