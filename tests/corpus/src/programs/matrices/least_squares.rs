//! `qr` of a matrix with more rows than columns solves least squares.

use bessemer::prelude::*;

/// The line `a + b·x` that fits six points best; `None` if all have the same x.
#[function]
pub fn line(x: &Vector6<f64>, y: &Vector6<f64>) -> Option<Vector2<f64>> {
    let mut rows = SMatrix::<f64, 6, 2>::from_element(1.0);
    for k in 0..6 {
        rows[(k, 1)] = x[k];
    }
    let qr = rows.qr();
    let right = qr.q().tr_mul(y);
    qr.r().solve_upper_triangular(&right)
}

/// The solution of a system by reflections, which need no pivots.
#[function]
pub fn solved(a: &Matrix3<f32>, b: &Vector3<f32>) -> Option<Vector3<f32>> {
    a.qr().solve(b)
}
