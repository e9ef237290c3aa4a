//! `max` by its bare name: the DSL does not see whose it is.
#![no_std]
use bessemer::prelude::*;
use core::cmp::max;

/// The larger.
#[function]
pub fn larger(a: u8, b: u8) -> u8 {
    max(a, b)
}
