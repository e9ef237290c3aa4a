//! Rotations as matrices: a matrix in the C.

use bessemer::prelude::*;

/// Turns what the sensor measures into the vehicle's frame.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mounting {
    /// From the sensor to the vehicle.
    pub rotation: Rotation3<f64>,
}

#[component]
impl Mounting {
    /// A measurement in the vehicle's frame.
    #[entry(infallible)]
    pub fn turned(&self, measured: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * measured
    }

    /// Mounts the sensor anew, turned on by `more`.
    #[entry(infallible)]
    pub fn mount(&mut self, more: &Rotation3<f64>) -> f64 {
        self.rotation = more * self.rotation;
        self.rotation.matrix().trace()
    }
}

/// Operators and methods.
#[function]
pub fn between(a: &Rotation3<f64>, b: Rotation3<f64>) -> Rotation3<f64> {
    let mut back = a.inverse() * b / a;
    back *= b.transpose();
    back.inverse_mut();
    back
}

/// There and back, of vectors and points.
#[function]
pub fn moved(m: &Rotation3<f32>, v: &Vector3<f32>, p: &Point3<f32>) -> (Vector3<f32>, Point3<f32>) {
    let there = m.transform_vector(v) + m * v;
    let point = m * p + m.inverse_transform_vector(&there);
    (there, m.inverse_transform_point(&point))
}

/// A covariance, turned.
#[function]
pub fn covariance(m: &Rotation3<f64>, p: &Matrix3<f64>) -> Matrix3<f64> {
    m * p * m.inverse()
}

/// From a matrix, and as one.
#[function]
pub fn raw(m: Matrix3<f64>) -> f64 {
    let rotation = Rotation3::from_matrix_unchecked(m);
    rotation[(2, 1)] + rotation.into_inner()[(0, 2)]
}

/// In the plane.
#[function]
pub fn plane(m: &Rotation2<f64>, v: &Vector2<f64>) -> Vector2<f64> {
    if *m == Rotation2::identity() { *v } else { m.transpose() * (m * v) }
}
