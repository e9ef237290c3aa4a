//! A case.
#![no_std]
use bessemer::prelude::*;

/// A matrix by one index.
#[function]
pub fn first(m: &Matrix3<f64>, n: usize) -> f64 {
    m[n]
}

/// A reference whose place is computed.
#[function]
pub fn second(values: &[f64; 3], n: usize) -> f64 {
    let value = &values[n];
    *value + 1.0
}
