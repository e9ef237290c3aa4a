#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Decompositions that iterate without a bound, or ask the platform.
#[function]
pub fn decompositions(a: Matrix4<f64>) -> f64 {
    let eigen = a.symmetric_eigen();
    let values = a.svd(true, true).singular_values;
    let factors = a.full_piv_lu();
    eigen.eigenvalues[0] + values[0] + factors.determinant()
}

/// A closure that moves what may change.
#[function]
pub fn closures(a: Matrix2<f64>, mut b: f64) -> Matrix2<f64> {
    b += 1.0;
    let c = a;
    c.zip_map(&a, move |x, y| x + y * b)
}

fn main() {}
