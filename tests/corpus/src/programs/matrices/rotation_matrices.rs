//! Rotations as matrices; each is a matrix in the C, too.

use bessemer::prelude::*;

/// Rotates measurements of a sensor into the vehicle's frame.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mounting {
    /// Rotation from the sensor's frame to the vehicle's.
    pub rotation: Rotation3<f64>,
}

#[component]
impl Mounting {
    /// A measurement in the vehicle's frame.
    #[entry(infallible)]
    pub fn turned(&self, measured: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * measured
    }

    /// Rotates the mounting by `more`; returns the angle.
    #[entry(infallible)]
    pub fn mount(&mut self, more: &Rotation3<f64>) -> f64 {
        self.rotation = more * self.rotation;
        self.rotation.matrix().trace()
    }
}

/// Uses operators and methods.
#[function]
pub fn between(a: &Rotation3<f64>, b: Rotation3<f64>) -> Rotation3<f64> {
    let mut back = a.inverse() * b / a;
    back *= b.transpose();
    back.inverse_mut();
    back
}

/// A vector and a point rotated, and back.
#[function]
pub fn moved(m: &Rotation3<f32>, v: &Vector3<f32>, p: &Point3<f32>) -> (Vector3<f32>, Point3<f32>) {
    let there = m.transform_vector(v) + m * v;
    let point = m * p + m.inverse_transform_vector(&there);
    (there, m.inverse_transform_point(&point))
}

/// A covariance in the rotated frame.
#[function]
pub fn covariance(m: &Rotation3<f64>, p: &Matrix3<f64>) -> Matrix3<f64> {
    m * p * m.inverse()
}

/// A rotation from a matrix, and the matrix of a rotation.
#[function]
pub fn raw(m: Matrix3<f64>) -> f64 {
    let rotation = Rotation3::from_matrix_unchecked(m);
    rotation[(2, 1)] + rotation.into_inner()[(0, 2)]
}

/// A rotation in the plane.
#[function]
pub fn plane(m: &Rotation2<f64>, v: &Vector2<f64>) -> Vector2<f64> {
    if *m == Rotation2::identity() { *v } else { m.transpose() * (m * v) }
}
