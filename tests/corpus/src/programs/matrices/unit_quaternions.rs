//! Rotations as unit quaternions: nalgebra's own type, its operators and its order of operations.

use bessemer::prelude::*;

/// A vehicle's attitude, and that of the camera on it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attitudes {
    /// From the body to the world.
    pub body: UnitQuaternion<f64>,
    /// From the camera to the body.
    pub camera: UnitQuaternion<f64>,
}

/// A point in the camera's frame, transformed to the world.
#[function]
pub fn in_world(attitudes: &Attitudes, seen: &Vector3<f64>) -> Vector3<f64> {
    attitudes.body * attitudes.camera * seen
}

/// The error of the attitude in the body's frame: twice the imaginary part, by the shorter way.
#[function]
pub fn error(wanted: &UnitQuaternion<f64>, is: &UnitQuaternion<f64>) -> Vector3<f64> {
    let error = is.inverse() * wanted;
    let sign = if error.w < 0.0 { -2.0 } else { 2.0 };
    Vector3::new(error.i, error.j, error.k) * sign
}

/// Turned by rates, rad/s, for a period, s, to first order.
#[function]
pub fn turned(attitude: &UnitQuaternion<f32>, rates: Vector3<f32>, period: f32) -> UnitQuaternion<f32> {
    attitude.append_axisangle_linearized(&(rates * period))
}

/// Half of the way, and the rest of it.
#[function]
pub fn halves(
    one: UnitQuaternion<f64>,
    other: UnitQuaternion<f64>,
) -> (UnitQuaternion<f64>, UnitQuaternion<f64>) {
    let middle = one.nlerp(&other, 0.5);
    (middle, middle.rotation_to(&other))
}

/// Equality of both rotations: a quaternion equals its opposite.
#[function]
pub fn same(one: &Attitudes, other: &Attitudes) -> (bool, bool) {
    (one == other, one.body == UnitQuaternion::new_unchecked(-one.body.into_inner()))
}

/// A quaternion that a sensor sent, brought to length 1; the identity if it is none.
#[function]
pub fn received(w: f64, i: f64, j: f64, k: f64) -> UnitQuaternion<f64> {
    let q = Quaternion::new(w, i, j, k);
    if q.norm_squared() > 0.5 { UnitQuaternion::from_quaternion(q) } else { UnitQuaternion::identity() }
}

/// To a matrix and back.
#[function]
pub fn there_and_back(q: UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&q.to_rotation_matrix())
}

/// With a matrix on either side.
#[function]
pub fn mixed(q: &UnitQuaternion<f64>, m: &Rotation3<f64>) -> UnitQuaternion<f64> {
    (q * m) / q * (m / q) / m
}

/// The parts, one by one and as a vector.
#[function]
pub fn parts(q: &UnitQuaternion<f32>) -> f32 {
    let unit = q.quaternion();
    unit.w + q.coords[1] * q.as_ref().coords.y + q.as_vector().norm() + unit.dot(q) + q.norm()
}

/// Points and directions, there and back.
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

/// Rotations in a row, all of them.
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

/// The axis, if there is one.
#[function]
pub fn axis(q: &UnitQuaternion<f64>) -> Vector3<f64> {
    match q.axis() {
        Some(axis) => axis.into_inner(),
        None => Vector3::zeros(),
    }
}
