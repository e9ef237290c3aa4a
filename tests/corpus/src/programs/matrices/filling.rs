//! Methods that fill, copy and swap parts of matrices. An index out of range is a fault.

use bessemer::prelude::*;

/// Makes a covariance symmetric, and each element of its diagonal at least `least`.
#[function]
pub fn tidy(p: &mut Matrix3<f64>, least: f64) {
    p.fill_lower_triangle_with_upper_triangle();
    let diagonal = p.diagonal().map(|x| if x > least { x } else { least });
    p.set_diagonal(&diagonal);
}

/// Resets the estimate of one state to a variance.
#[function]
pub fn forget(p: &mut Matrix3<f64>, state: usize, variance: f64) {
    p.fill_row(state, 0.0);
    p.fill_column(state, 0.0);
    p[(state, state)] = variance;
}

/// Swaps two rows.
#[function]
pub fn exchanged(mut a: SMatrix<f32, 3, 2>, one: usize, other: usize) -> SMatrix<f32, 3, 2> {
    a.swap_rows(one, other);
    a
}

/// Resets a covariance to a multiple of the identity.
#[function]
pub fn reset(p: &mut Matrix2<f64>, variance: f64) {
    p.fill_with_identity();
    p.scale_mut(variance);
}
