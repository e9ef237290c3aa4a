#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Decompositions that iterate without a bound, or ask the platform.
#[function]
pub fn decompositions(a: Matrix4<f64>) -> f64 {
    let eigen = a.symmetric_eigen();
    let values = a.svd(true, true).singular_values;
    let factors = a.full_piv_lu();
    eigen.eigenvalues[0] + values[0] + factors.determinant() + a.lp_norm(3)
}

/// A closure that leaves its function, and one that moves.
#[function]
pub fn closures(a: Matrix2<f64>, b: f64) -> Matrix2<f64> {
    let c = a.map(|x| {
        if x < 0.0 {
            return 0.0;
        }
        x
    });
    c.zip_map(&a, move |x, y| x + y * b)
}

fn main() {}
