//! `zip`, `enumerate` and `rev` become one loop over indices.

use bessemer::prelude::*;

/// A weighted sum.
#[function]
pub fn weighted(values: &[f64; 5], weights: &[f64; 5]) -> f64 {
    let mut sum = 0.0;
    for (value, weight) in values.iter().zip(weights) {
        sum += value * weight;
    }
    sum
}

/// The index of the first value above a limit, or 6.
#[function]
pub fn first_above(values: &[i32; 6], limit: i32) -> usize {
    for (i, value) in values.iter().enumerate() {
        if *value > limit {
            return i;
        }
    }
    6
}
