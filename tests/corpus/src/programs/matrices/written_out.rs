//! Vectors and matrices from their elements, of any size, with `vector!` and `matrix!`.

use bessemer::prelude::*;

/// The coefficients of a filter of seven taps.
#[function]
pub fn taps(edge: f64) -> SVector<f64, 7> {
    vector![edge, -0.1, 0.25, 0.5, 0.25, -0.1, edge.abs()]
}

/// Transition matrix of position, speed and bias over a time, s.
#[function]
pub fn transition(time: f64) -> Matrix3<f64> {
    matrix![
        1.0, time, 0.0;
        0.0, 1.0, -time;
        0.0, 0.0, 1.0
    ]
}

/// A frame of two axes and their cross product, as columns.
#[function]
pub fn frame(x: &Vector3<f32>, y: &Vector3<f32>) -> Matrix3<f32> {
    Matrix3::from_columns(&[*x, *y, x.cross(y)])
}

/// A matrix of a table's rows.
#[function]
pub fn table(values: &[f64; 6]) -> SMatrix<f64, 2, 3> {
    SMatrix::<f64, 2, 3>::from_row_slice(values)
}

/// Direction perpendicular to a vector and the vertical.
#[function]
pub fn across(v: &Vector3<f64>) -> Vector3<f64> {
    v.cross(&Vector3::z())
}

/// The matrix of the cross product, and one with a single value on its diagonal.
#[function]
pub fn others(v: &Vector3<f64>, noise: f64) -> Matrix3<f64> {
    v.cross_matrix() + Matrix3::from_diagonal_element(noise)
}

/// The mean of the elements.
#[function]
pub fn mean(a: &SMatrix<f64, 2, 3>) -> f64 {
    a.sum() / (a.nrows() * a.ncols()) as f64
}
