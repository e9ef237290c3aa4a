//! Poses (rigid motions): a rotation followed by a translation.

use nalgebra::{Isometry3 as Native, Matrix4, Translation3, UnitQuaternion, Vector3};

use crate::math::Real;
use crate::{data, function, library};

/// A pose: a rotation followed by a translation.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isometry3<T: Real> {
    /// Rotation, applied first.
    pub rotation: UnitQuaternion<T>,
    /// Translation, applied second.
    pub translation: Translation3<T>,
}

/// The pose that only translates.
#[function]
pub fn from_translation<T: Real>(translation: Translation3<T>) -> Native<T> {
    Native::from_parts(translation, UnitQuaternion::identity())
}

#[library(IsometryCompanions)]
impl<T: Real> Native<T> {
    /// The pose that moves nothing.
    pub fn identity() -> Self {
        Native::from_parts(Translation3::identity(), UnitQuaternion::identity())
    }

    /// The pose that translates by (`x`, `y`, `z`) and does not rotate.
    pub fn translation(x: T, y: T, z: T) -> Self {
        Native::from_parts(Translation3::new(x, y, z), UnitQuaternion::identity())
    }

    /// The inverse pose: it undoes the rotation and the translation.
    pub fn inverse(pose: &Self) -> Self {
        let rotation = pose.rotation.inverse();
        let back = -pose.translation.vector;
        Native::from_parts(Translation3::from(rotation.transform_vector(&back)), rotation)
    }

    /// Inverts a pose in place.
    pub fn inverse_mut(pose: &mut Self) {
        *pose = inverse(pose);
    }

    /// The pose `second` relative to `first`: the inverse of `first` times `second`.
    pub fn inv_mul(first: &Self, second: &Self) -> Self {
        let back = first.rotation.inverse();
        let between = second.translation.vector - first.translation.vector;
        Native::from_parts(
            Translation3::from(back.transform_vector(&between)),
            back * second.rotation,
        )
    }

    /// Rotates a vector by the pose's rotation; a vector has no position, so it is not translated.
    pub fn transform_vector(pose: &Self, vector: &Vector3<T>) -> Vector3<T> {
        pose.rotation.transform_vector(vector)
    }

    /// Rotates a vector by the inverse of the pose's rotation.
    pub fn inverse_transform_vector(pose: &Self, vector: &Vector3<T>) -> Vector3<T> {
        pose.rotation.inverse_transform_vector(vector)
    }

    /// The 4 × 4 matrix of the pose for homogeneous coordinates.
    #[method(to_homogeneous, to_matrix)]
    pub fn to_homogeneous(pose: &Self) -> Matrix4<T> {
        let mut matrix = pose.rotation.to_homogeneous();
        for row in 0..3 {
            matrix[(row, 3)] = pose.translation.vector[row];
        }
        matrix
    }

    /// Adds a translation that is applied after the pose.
    pub fn append_translation_mut(pose: &mut Self, by: &Translation3<T>) {
        pose.translation.vector += by.vector;
    }

    /// Adds a rotation that is applied after the pose; it also rotates the pose's translation.
    pub fn append_rotation_mut(pose: &mut Self, q: &UnitQuaternion<T>) {
        pose.rotation = q * pose.rotation;
        pose.translation.vector = q.transform_vector(&pose.translation.vector);
    }
}

/// The pose that applies `second` and then `first`.
#[function]
pub fn product<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    let shift = first.rotation.transform_vector(&second.translation.vector);
    Native::from_parts(
        Translation3::from(first.translation.vector + shift),
        first.rotation * second.rotation,
    )
}

/// The pose that applies the inverse of `second` and then `first`.
#[function]
pub fn quotient<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    product(first, &inverse(second))
}

/// The pose that applies the rotation `q` and then `pose`.
#[function]
pub fn product_with_rotation<T: Real>(pose: &Native<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(pose.translation, pose.rotation * q)
}

/// The pose that applies the inverse of the rotation `q` and then `pose`.
#[function]
pub fn quotient_by_rotation<T: Real>(pose: &Native<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(pose.translation, pose.rotation / q)
}

/// The pose that applies `pose` and then the rotation `q`.
#[function]
pub fn product_of_rotation<T: Real>(q: &UnitQuaternion<T>, pose: &Native<T>) -> Native<T> {
    let shift = q.transform_vector(&pose.translation.vector);
    Native::from_parts(Translation3::from(shift), q * pose.rotation)
}

/// The pose that applies the inverse of `pose` and then the rotation `q`.
#[function]
pub fn quotient_of_rotation<T: Real>(q: &UnitQuaternion<T>, pose: &Native<T>) -> Native<T> {
    product_of_rotation(q, &inverse(pose))
}

/// The pose that applies the translation `by` and then `pose`.
#[function]
pub fn product_with_translation<T: Real>(pose: &Native<T>, by: &Translation3<T>) -> Native<T> {
    let shifted = pose.translation.vector + pose.rotation.transform_vector(&by.vector);
    Native::from_parts(Translation3::from(shifted), pose.rotation)
}

/// The pose that applies `pose` and then the translation `by`.
#[function]
pub fn product_of_translation<T: Real>(by: &Translation3<T>, pose: &Native<T>) -> Native<T> {
    Native::from_parts(Translation3::from(by.vector + pose.translation.vector), pose.rotation)
}

/// The pose that applies the translation `by` and then the rotation `q`.
#[function]
pub fn rotated_translation<T: Real>(q: &UnitQuaternion<T>, by: &Translation3<T>) -> Native<T> {
    Native::from_parts(Translation3::from(q.transform_vector(&by.vector)), *q)
}

/// The pose that applies the rotation `q` and then the translation `by`.
#[function]
pub fn translated_rotation<T: Real>(by: &Translation3<T>, q: &UnitQuaternion<T>) -> Native<T> {
    Native::from_parts(*by, *q)
}

/// Rotates and then translates a point.
#[function]
pub fn transform_point<T: Real>(pose: &Native<T>, point: &Vector3<T>) -> Vector3<T> {
    pose.rotation.transform_vector(point) + pose.translation.vector
}

/// Applies the inverse of a pose to a point: it is translated and then rotated.
#[function]
pub fn inverse_transform_point<T: Real>(pose: &Native<T>, point: &Vector3<T>) -> Vector3<T> {
    pose.rotation.inverse_transform_vector(&(point - pose.translation.vector))
}
