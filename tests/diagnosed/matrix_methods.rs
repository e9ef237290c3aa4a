//! A case.
#![no_std]
use bessemer::prelude::*;

/// Factors of a matrix with more columns than rows, and one of the elements' methods for the whole.
#[function]
pub fn caller(m: &Matrix3<f64>, wide: &SMatrix<f64, 2, 3>) -> f64 {
    let factors = wide.qr();
    factors.r()[(0, 0)] + m.component_mul(&m.transpose()).rank(1e-9) as f64
}
