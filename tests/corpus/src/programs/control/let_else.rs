//! `let … else` exits if the pattern does not match.

use bessemer::prelude::*;

/// The mean of the valid ones of two readings.
#[function]
pub fn mean(one: Option<f64>, other: Option<f64>) -> f64 {
    let Some(first) = one else {
        return other.unwrap_or(0.0);
    };
    let Some(second) = other else {
        return first;
    };
    (first + second) / 2.0
}
