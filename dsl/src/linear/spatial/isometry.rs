//! Poses: a rotation, and then a translation.

use nalgebra::{Isometry3 as Native, Matrix4, Translation3, UnitQuaternion, Vector3};

use crate::math::Real;
use crate::{data, function, library};

/// A pose: a rotation, and then a translation.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isometry3<T: Real> {
    /// Rotation, applied first.
    pub rotation: UnitQuaternion<T>,
    /// Translation, applied second.
    pub translation: Translation3<T>,
}

/// A translation without a rotation.
#[function]
pub fn from_translation<T: Real>(translation: Translation3<T>) -> Native<T> {
    Native::from_parts(translation, UnitQuaternion::identity())
}

#[library(IsometryCompanions)]
impl<T: Real> Native<T> {
    /// The pose of the origin.
    pub fn identity() -> Self {
        Native::from_parts(Translation3::identity(), UnitQuaternion::identity())
    }

    /// A translation without a rotation.
    pub fn translation(x: T, y: T, z: T) -> Self {
        Native::from_parts(Translation3::new(x, y, z), UnitQuaternion::identity())
    }

    /// The pose back.
    pub fn inverse(pose: &Self) -> Self {
        let rotation = pose.rotation.inverse();
        let back = -pose.translation.vector;
        Native::from_parts(Translation3::from(rotation.transform_vector(&back)), rotation)
    }

    /// Inverts a pose in place.
    pub fn inverse_mut(pose: &mut Self) {
        *pose = inverse(pose);
    }

    /// `second`, seen from `first`.
    pub fn inv_mul(first: &Self, second: &Self) -> Self {
        let back = first.rotation.inverse();
        let between = second.translation.vector - first.translation.vector;
        Native::from_parts(
            Translation3::from(back.transform_vector(&between)),
            back * second.rotation,
        )
    }

    /// The vector turned.
    pub fn transform_vector(pose: &Self, vector: &Vector3<T>) -> Vector3<T> {
        pose.rotation.transform_vector(vector)
    }

    /// The vector turned back.
    pub fn inverse_transform_vector(pose: &Self, vector: &Vector3<T>) -> Vector3<T> {
        pose.rotation.inverse_transform_vector(vector)
    }

    /// The matrix that moves homogeneous coordinates so.
    #[method(to_homogeneous, to_matrix)]
    pub fn to_homogeneous(pose: &Self) -> Matrix4<T> {
        let mut matrix = pose.rotation.to_homogeneous();
        for row in 0..3 {
            matrix[(row, 3)] = pose.translation.vector[row];
        }
        matrix
    }

    /// A translation on top.
    pub fn append_translation_mut(pose: &mut Self, by: &Translation3<T>) {
        pose.translation.vector += by.vector;
    }

    /// A rotation on top.
    pub fn append_rotation_mut(pose: &mut Self, q: &UnitQuaternion<T>) {
        pose.rotation = q * pose.rotation;
        pose.translation.vector = q.transform_vector(&pose.translation.vector);
    }
}

/// `second`, and then `first`.
#[function]
pub fn product<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    let shift = first.rotation.transform_vector(&second.translation.vector);
    Native::from_parts(
        Translation3::from(first.translation.vector + shift),
        first.rotation * second.rotation,
    )
}

/// `second` back, and then `first`.
#[function]
pub fn quotient<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    product(first, &inverse(second))
}

/// A rotation, and then the pose.
#[function]
pub fn product_with_rotation<T: Real>(pose: &Native<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(pose.translation, pose.rotation * q)
}

/// A rotation back, and then the pose.
#[function]
pub fn quotient_by_rotation<T: Real>(pose: &Native<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(pose.translation, pose.rotation / q)
}

/// The pose, and then a rotation.
#[function]
pub fn product_of_rotation<T: Real>(q: &UnitQuaternion<T>, pose: &Native<T>) -> Native<T> {
    let shift = q.transform_vector(&pose.translation.vector);
    Native::from_parts(Translation3::from(shift), q * pose.rotation)
}

/// The pose back, and then a rotation.
#[function]
pub fn quotient_of_rotation<T: Real>(q: &UnitQuaternion<T>, pose: &Native<T>) -> Native<T> {
    product_of_rotation(q, &inverse(pose))
}

/// A translation, and then the pose.
#[function]
pub fn product_with_translation<T: Real>(pose: &Native<T>, by: &Translation3<T>) -> Native<T> {
    let shifted = pose.translation.vector + pose.rotation.transform_vector(&by.vector);
    Native::from_parts(Translation3::from(shifted), pose.rotation)
}

/// The pose, and then a translation.
#[function]
pub fn product_of_translation<T: Real>(by: &Translation3<T>, pose: &Native<T>) -> Native<T> {
    Native::from_parts(Translation3::from(by.vector + pose.translation.vector), pose.rotation)
}

/// A translation, and then a rotation.
#[function]
pub fn rotated_translation<T: Real>(q: &UnitQuaternion<T>, by: &Translation3<T>) -> Native<T> {
    Native::from_parts(Translation3::from(q.transform_vector(&by.vector)), *q)
}

/// A rotation, and then a translation.
#[function]
pub fn translated_rotation<T: Real>(by: &Translation3<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(*by, *q)
}

/// The point turned and moved.
#[function]
pub fn transform_point<T: Real>(pose: &Native<T>, point: &Vector3<T>) -> Vector3<T> {
    pose.rotation.transform_vector(point) + pose.translation.vector
}

/// The point moved and turned back.
#[function]
pub fn inverse_transform_point<T: Real>(pose: &Native<T>, point: &Vector3<T>) -> Vector3<T> {
    pose.rotation.inverse_transform_vector(&(point - pose.translation.vector))
}
