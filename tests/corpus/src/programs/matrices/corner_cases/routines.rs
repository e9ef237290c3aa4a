//! Routines of linear algebra that no other program uses, in both precisions.

use bessemer::prelude::*;

/// True if the sign is inverted.
const TURNED: bool = true;

#[function]
pub fn component_wise(a: &Matrix2<f64>, b: &Matrix2<f64>) -> Matrix2<f64> {
    let sign = if TURNED { -(a.component_mul(b)) } else { a.component_mul(b) };
    sign.component_div(b)
}

#[function]
pub fn component_wise_single(a: &Matrix3<f32>, b: &Matrix3<f32>) -> Matrix3<f32> {
    (-a).component_mul(b).component_div(a)
}

#[function]
pub fn across_single(a: &Vector3<f32>, b: &Vector3<f32>) -> Vector3<f32> {
    a.cross(b)
}

#[function]
pub fn transposed_single(a: &SMatrix<f32, 2, 3>, b: &SMatrix<f32, 2, 4>) -> SMatrix<f32, 4, 3> {
    a.tr_mul(b).transpose()
}

#[function]
pub fn double(x: &mut f64) {
    *x *= 2.0;
}

#[function]
pub fn lent_element(a: &mut Matrix2<f64>, at: usize) {
    double(&mut a[(at, 1)]);
    double(&mut a[(0, at)]);
}
