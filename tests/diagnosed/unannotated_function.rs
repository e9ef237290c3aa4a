//! A case.
#![no_std]
use bessemer::prelude::*;

fn helper(x: f64) -> f64 {
    x + 1.0
}

/// Calls it.
#[function]
pub fn caller(x: f64) -> f64 {
    helper(x) * 2.0
}
