//! Methods that fill, copy and exchange parts of matrices. An index beyond the end is a fault.

use bessemer::prelude::*;

/// Makes a covariance symmetric and its diagonal at least so large.
#[function]
pub fn tidy(p: &mut Matrix3<f64>, least: f64) {
    p.fill_lower_triangle_with_upper_triangle();
    let diagonal = p.diagonal().map(|x| if x > least { x } else { least });
    p.set_diagonal(&diagonal);
}

/// Forgets what is known of one state.
#[function]
pub fn forget(p: &mut Matrix3<f64>, state: usize, variance: f64) {
    p.fill_row(state, 0.0);
    p.fill_column(state, 0.0);
    p[(state, state)] = variance;
}

/// Exchanges two rows.
#[function]
pub fn exchanged(mut a: SMatrix<f32, 3, 2>, one: usize, other: usize) -> SMatrix<f32, 3, 2> {
    a.swap_rows(one, other);
    a
}

/// A part of the identity.
#[function]
pub fn reset(p: &mut Matrix2<f64>, variance: f64) {
    p.fill_with_identity();
    p.scale_mut(variance);
}
