//! A case.
#![no_std]
use bessemer::prelude::*;

/// A matrix by one index.
#[function]
pub fn caller(m: &Matrix3<f64>, n: usize) -> f64 {
    m[n]
}
