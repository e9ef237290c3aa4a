//! Powers and the exponential of square matrices.

use bessemer::prelude::*;

/// A linear system some steps ahead.
#[function]
pub fn ahead(a: &Matrix2<f64>, steps: u32) -> Matrix2<f64> {
    a.pow(steps)
}

/// Transition matrix of a linear system over a time, s.
#[function]
pub fn transition(a: &Matrix2<f64>, time: f64) -> Matrix2<f64> {
    (a * time).exp()
}
