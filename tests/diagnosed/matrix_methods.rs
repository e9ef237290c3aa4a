//! A case.
#![no_std]
use bessemer::prelude::*;

/// A function where a closure is wanted, and factors of a matrix with more columns than rows.
#[function]
pub fn caller(m: &Matrix3<f64>, wide: &SMatrix<f64, 2, 3>) -> f64 {
    let sorted = m.zip_map(m, f64::min);
    let factors = wide.qr();
    sorted[0] + factors.r()[(0, 0)]
}
