//! A case.
#![no_std]
use bessemer::prelude::*;

/// A sum of what is no number.
#[function]
pub fn first(list: &[Vector2<f64>; 3]) -> Vector2<f64> {
    list.iter().sum()
}

/// A reference whose place is computed.
#[function]
pub fn second(values: &[f64; 3], n: usize) -> f64 {
    let value = &values[n];
    *value + 1.0
}
