//! A case.
#![no_std]
use bessemer::prelude::*;

/// One half.
#[function]
pub fn even(n: u32) -> bool {
    if n == 0 { true } else { odd(n - 1) }
}

/// The other.
#[function]
pub fn odd(n: u32) -> bool {
    if n == 0 { false } else { even(n - 1) }
}
