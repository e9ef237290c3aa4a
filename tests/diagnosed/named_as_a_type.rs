//! A case.
#![no_std]
use bessemer::prelude::*;

/// A function whose C name would hide the type.
#[function]
pub fn f64(count: u8) -> u8 {
    count / 2
}

/// The type is Rust's.
#[function]
pub fn caller(x: f64) -> f64 {
    2.0 * x
}
