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

/// A view that goes by another name, one that is named where its matrix is, and one that the function may leave.
#[function]
pub fn named_views(a: &mut Matrix4<f64>, b: &Vector4<f64>) -> Option<f64> {
    let mut first = a.column_mut(0);
    first += b;
    let mut other = first;
    other += b;
    let mut second = a.column_mut(1);
    if b.x > 0.0 {
        second += b;
    } else {
        a.fill(0.0);
    }
    let mut third = a.row_mut(2);
    if b.y > 0.0 {
        third[0] = Some(b.y).filter(|y| *y > 1.0)?;
    }
    Some(b.z)
}

fn main() {}
