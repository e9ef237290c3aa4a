//! A case.
#![no_std]
use bessemer::prelude::*;

/// rustc's own error, said once.
#[function]
pub fn caller(x: f64, n: i32) -> f64 {
    x * n
}
