//! Elements by row and column, by position, and by the letters of short vectors.

use bessemer::prelude::*;

/// The rotation about the third axis with this sine and cosine.
#[function]
pub fn turn(sine: f64, cosine: f64) -> Matrix3<f64> {
    let mut matrix = Matrix3::identity();
    matrix[(0, 0)] = cosine;
    matrix[(0, 1)] = -sine;
    matrix[(1, 0)] = sine;
    matrix[(1, 1)] = cosine;
    matrix
}

/// The angle of a rotation about the third axis, by nalgebra's names of the elements, rad.
#[function]
pub fn angle(turn: &Matrix3<f64>) -> f64 {
    turn.m21.atan2(turn.m11)
}

/// The components of a vector in another order.
#[function]
pub fn reordered(v: &Vector3<f32>) -> Vector3<f32> {
    Vector3::new(v.z, v.x, v[1])
}
