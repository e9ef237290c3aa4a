//! Systems of equations and inverses, solved in place, of any fixed size.

use bessemer::prelude::*;

/// The coefficients of the parabola through three points; NaN if two points have the same x.
#[function]
pub fn parabola(x: &Vector3<f64>, y: &Vector3<f64>) -> Vector3<f64> {
    let mut powers = Matrix3::zeros();
    for row in 0..3 {
        powers[(row, 0)] = 1.0;
        powers[(row, 1)] = x[row];
        powers[(row, 2)] = x[row] * x[row];
    }
    let mut coefficients = *y;
    bessemer::solve_mut(&mut powers, &mut coefficients);
    coefficients
}

/// The gain of a filter: P·(P + R)⁻¹, or 0 if the sum has no inverse.
#[function]
pub fn gain(p: &SMatrix<f64, 6, 6>, r: &SMatrix<f64, 6, 6>) -> SMatrix<f64, 6, 6> {
    let mut inverse = p + r;
    if bessemer::inverse_mut(&mut inverse) { p * inverse } else { SMatrix::zeros() }
}

/// Returns true if a matrix keeps handedness.
#[function]
pub fn keeps_handedness(turn: &Matrix3<f32>) -> bool {
    turn.determinant() > 0.0
}
