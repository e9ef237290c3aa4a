//! Rotations as unit quaternions: nalgebra's own type, its operators and its order of operations.

use bessemer::prelude::*;

/// A vehicle's attitude, and the attitude of its camera.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attitudes {
    /// Rotation from the body's frame to the world's.
    pub body: UnitQuaternion<f64>,
    /// Rotation from the camera's frame to the body's.
    pub camera: UnitQuaternion<f64>,
}

/// A point in the camera's frame, transformed to the world.
#[function]
pub fn in_world(attitudes: &Attitudes, seen: &Vector3<f64>) -> Vector3<f64> {
    attitudes.body * attitudes.camera * seen
}

/// The attitude error in the body's frame: twice the imaginary part, with the sign for the shorter rotation.
#[function]
pub fn error(wanted: &UnitQuaternion<f64>, is: &UnitQuaternion<f64>) -> Vector3<f64> {
    let error = is.inverse() * wanted;
    let sign = if error.w < 0.0 { -2.0 } else { 2.0 };
    Vector3::new(error.i, error.j, error.k) * sign
}

/// The attitude after `period` s at rates in rad/s, to first order.
#[function]
pub fn turned(attitude: &UnitQuaternion<f32>, rates: Vector3<f32>, period: f32) -> UnitQuaternion<f32> {
    attitude.append_axisangle_linearized(&(rates * period))
}

/// Half of a rotation, and the remaining rotation.
#[function]
pub fn halves(
    one: UnitQuaternion<f64>,
    other: UnitQuaternion<f64>,
) -> (UnitQuaternion<f64>, UnitQuaternion<f64>) {
    let middle = one.nlerp(&other, 0.5);
    (middle, middle.rotation_to(&other))
}

/// Tests both rotations for equality; a quaternion equals its negative.
#[function]
pub fn same(one: &Attitudes, other: &Attitudes) -> (bool, bool) {
    (one == other, one.body == UnitQuaternion::new_unchecked(-one.body.into_inner()))
}

/// A received quaternion, normalised; the identity if it is too short.
#[function]
pub fn received(w: f64, i: f64, j: f64, k: f64) -> UnitQuaternion<f64> {
    let q = Quaternion::new(w, i, j, k);
    if q.norm_squared() > 0.5 { UnitQuaternion::from_quaternion(q) } else { UnitQuaternion::identity() }
}

/// Converts a rotation to a matrix and back.
#[function]
pub fn there_and_back(q: UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&q.to_rotation_matrix())
}

/// Products of a quaternion and a matrix, in both orders.
#[function]
pub fn mixed(q: &UnitQuaternion<f64>, m: &Rotation3<f64>) -> UnitQuaternion<f64> {
    (q * m) / q * (m / q) / m
}

/// The parts of a quaternion, individually and as a vector.
#[function]
pub fn parts(q: &UnitQuaternion<f32>) -> f32 {
    let unit = q.quaternion();
    unit.w + q.coords[1] * q.as_ref().coords.y + q.as_vector().norm() + unit.dot(q) + q.norm()
}

/// Points and directions rotated, and back.
#[function]
pub fn points(
    q: &UnitQuaternion<f64>,
    p: &Point3<f64>,
    d: &UnitVector3<f64>,
) -> (Point3<f64>, UnitVector3<f64>, Matrix4<f64>) {
    let there = q * p;
    let back = q.inverse_transform_point(&(there + d.into_inner()));
    (back, q * d, q.to_homogeneous())
}

/// The product of several rotations.
#[function]
pub fn all(joints: &[UnitQuaternion<f64>; 4]) -> UnitQuaternion<f64> {
    let mut whole = UnitQuaternion::identity();
    for joint in joints {
        whole *= joint;
    }
    whole.renormalize();
    whole.inverse_mut();
    whole / joints[0]
}

/// The axis; zero if there is none.
#[function]
pub fn axis(q: &UnitQuaternion<f64>) -> Vector3<f64> {
    match q.axis() {
        Some(axis) => axis.into_inner(),
        None => Vector3::zeros(),
    }
}
