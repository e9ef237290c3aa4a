#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A matrix of any size.
#[function]
pub fn dynamic_matrix(a: &Matrix3<f64>) -> f64 {
    let all: DVector<f64> = DVector::zeros(3);
    let square = DMatrix::<f64>::identity(3, 3);
    a.determinant() + all[0] + square[(0, 0)]
}

fn main() {}
