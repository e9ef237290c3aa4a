//! A case.
#![no_std]
use bessemer::prelude::*;

/// A sum of what is no number.
#[function]
pub fn first(list: &[Option<f64>; 3]) -> Option<f64> {
    list.iter().copied().sum()
}

/// A reference to a value that is computed.
#[function]
pub fn second(values: &[f64; 3], n: usize) -> f64 {
    let value = &(values[n] * 2.0);
    *value + 1.0
}
