//! Rotations by nalgebra's names, which are replaced by the functions of `bessemer::rotation`.

use bessemer::nalgebra::{Unit, UnitVector3};
use bessemer::prelude::*;

/// Converts three angles to a quaternion and back.
#[function]
pub fn there_and_back(roll: f64, pitch: f64, yaw: f64) -> (f64, f64, f64) {
    let q = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    q.euler_angles()
}

/// Converts three angles to a matrix and back.
#[function]
pub fn by_matrix(roll: f32, pitch: f32, yaw: f32) -> (f32, f32, f32) {
    Rotation3::from_euler_angles(roll, pitch, yaw).euler_angles()
}

/// A fraction of a rotation about an axis whose length is the angle.
#[function]
pub fn part_of_the_way(a: Vector3<f64>, b: Vector3<f64>, share: f64) -> Vector3<f64> {
    let from = UnitQuaternion::from_scaled_axis(a);
    let to = UnitQuaternion::new(b);
    from.slerp(&to, share).scaled_axis()
}

/// The rotation between two directions, as its axis and its angle.
#[function]
pub fn between(a: Vector3<f64>, b: Vector3<f64>) -> Option<(Vector3<f64>, f64)> {
    let (from, length) = Unit::try_new_and_get(a, 1e-6)?;
    let to = Unit::try_new(b, 1e-6)?;
    let turn = UnitQuaternion::rotation_between_axis(&from, &to)?;
    let (axis, angle) = turn.axis_angle()?;
    Some((axis.into_inner() * length, angle))
}

/// A fraction of the rotation between two directions of any length; `None` if they are opposite.
#[function]
pub fn share_between(a: &Vector3<f32>, b: &Vector3<f32>, share: f32) -> Option<[f32; 4]> {
    let whole = UnitQuaternion::rotation_between(a, b)?;
    let part = UnitQuaternion::scaled_rotation_between(a, b, share)?;
    let along = UnitQuaternion::scaled_rotation_between_axis(&Vector3::x_axis(), &Unit::try_new(*b, 1e-6)?, share)?;
    let left = part.rotation_to(&whole) * along;
    Some([left.w, left.i, left.j, left.k])
}

/// A rotation about an axis.
#[function]
pub fn about(axis: &UnitVector3<f32>, angle: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(axis, angle)
}
