//! Small methods that are often used: shapes, single elements, copies, conversions, sums of vectors.

use bessemer::prelude::*;

/// A quadratic form as a 1 × 1 matrix, and the components of a row vector by their names.
#[function]
pub fn quadratic(v: &Vector3<f64>, a: &Matrix3<f64>) -> (f64, f64, f64) {
    let row = v.transpose() * a;
    ((row * v).into_scalar(), (row * v).to_scalar() + (row * v).x, row.x - row.z)
}

/// The perpendicular product of two vectors in a plane.
#[function]
pub fn turn(a: &Vector2<f32>, b: &Vector2<f32>) -> f32 {
    a.perp(b)
}

/// The shape of a matrix, which is constant.
#[function]
pub fn shapes(a: &SMatrix<f64, 2, 3>) -> (usize, bool) {
    let (rows, columns) = a.shape();
    (10 * rows + columns, a.is_square())
}

/// An explicit copy of a matrix.
#[function]
pub fn squared(a: &Matrix2<f64>) -> Matrix2<f64> {
    let copy = a.clone();
    copy.clone() * copy
}

/// Converts a matrix to single precision and back.
#[function]
pub fn rounded(a: &SMatrix<f64, 2, 3>) -> (SMatrix<f32, 2, 3>, SMatrix<f64, 2, 3>) {
    let single = a.cast::<f32>();
    (single, single.cast::<f64>() - a)
}

/// The mean of points, and the sum of their halves.
#[function]
pub fn centre(points: &[Vector3<f64>; 4]) -> (Vector3<f64>, Vector3<f64>) {
    let sum: Vector3<f64> = points.iter().sum();
    (sum / 4.0, points.iter().map(|point| point * 0.5).sum())
}

/// Products written to existing matrices.
#[function]
pub fn into_places(a: &SMatrix<f64, 2, 3>, b: &SMatrix<f64, 3, 2>, product: &mut Matrix2<f64>, other: &mut SMatrix<f64, 3, 3>) {
    a.mul_to(b, product);
    a.tr_mul_to(a, other);
}

/// A view as a value, and a vector's index.
#[function]
pub fn parts(state: &SVector<f64, 6>) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
    let position = Vector3::from(state.fixed_rows::<3>(0));
    let velocity: Vector3<f64> = state.fixed_rows::<3>(3).into();
    (position, velocity, Vector3::from_fn(|row, _| position[row] + row as f64))
}
