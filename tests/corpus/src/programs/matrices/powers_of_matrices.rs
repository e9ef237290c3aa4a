//! Powers and the exponential of square matrices.

use bessemer::prelude::*;

/// The transition matrix of a linear system over some steps.
#[function]
pub fn ahead(a: &Matrix2<f64>, steps: u32) -> Matrix2<f64> {
    a.pow(steps)
}

/// Transition matrix of a linear system over a time, s.
#[function]
pub fn transition(a: &Matrix2<f64>, time: f64) -> Matrix2<f64> {
    (a * time).exp()
}
