//! Unit quaternions: rotations in space.

use nalgebra::{
    Matrix3, Matrix4, Quaternion, Rotation3, Unit, UnitQuaternion as Native, UnitVector3, Vector3,
};

use super::quaternion;
use crate::math::{Real, real};
use crate::{data, function, library};

/// A rotation: the quaternion w + i·𝐢 + j·𝐣 + k·𝐤 of length 1.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnitQuaternion<T> {
    /// sin(angle/2) times the first component of the axis.
    pub i: T,
    /// sin(angle/2) times the second component of the axis.
    pub j: T,
    /// sin(angle/2) times the third component of the axis.
    pub k: T,
    /// cos(angle/2).
    pub w: T,
}

#[library(UnitQuaternionCompanions)]
impl<T: Real> Native<T> {
    /// The unit quaternion in the direction of `q`.
    #[method(from_quaternion)]
    #[by_value(q)]
    pub fn new_normalize(q: &Quaternion<T>) -> Self {
        let length = quaternion::norm(q);
        Native::new_unchecked(Quaternion::new(
            q.w / length,
            q.i / length,
            q.j / length,
            q.k / length,
        ))
    }

    /// The inverse rotation: by the same angle in the opposite direction.
    #[method(inverse, conjugate)]
    pub fn inverse(q: &Self) -> Self {
        Native::new_unchecked(Quaternion::new(q.w, -q.i, -q.j, -q.k))
    }

    /// Inverts a rotation in place.
    #[method(inverse_mut, conjugate_mut)]
    pub fn inverse_mut(q: &mut Self) {
        *q = inverse(q);
    }

    /// The rotation from `from` to `to`: `to` after the inverse of `from`.
    pub fn rotation_to(from: &Self, to: &Self) -> Self {
        quotient(to, from)
    }

    /// Rotates a vector.
    pub fn transform_vector(q: &Self, vector: &Vector3<T>) -> Vector3<T> {
        let axis = Vector3::new(q.i, q.j, q.k);
        let across = axis.cross(vector) * real::<T>(2.0);
        let twice = axis.cross(&across);
        across * q.w + twice + vector
    }

    /// Rotates a vector by the inverse rotation.
    pub fn inverse_transform_vector(q: &Self, vector: &Vector3<T>) -> Vector3<T> {
        transform_vector(&inverse(q), vector)
    }

    /// The 3 × 3 matrix of the rotation.
    #[by_value(q)]
    pub fn to_rotation_matrix(q: &Self) -> Rotation3<T> {
        let two: T = real(2.0);
        let ww = q.w * q.w;
        let ii = q.i * q.i;
        let jj = q.j * q.j;
        let kk = q.k * q.k;
        let ij = q.i * q.j * two;
        let wk = q.w * q.k * two;
        let wj = q.w * q.j * two;
        let ik = q.i * q.k * two;
        let jk = q.j * q.k * two;
        let wi = q.w * q.i * two;
        Rotation3::from_matrix_unchecked(Matrix3::new(
            ww + ii - jj - kk,
            ij - wk,
            wj + ik,
            wk + ij,
            ww - ii + jj - kk,
            jk - wi,
            ik - wj,
            wi + jk,
            ww - ii - jj + kk,
        ))
    }

    /// Rotation matrix for homogeneous coordinates.
    #[by_value(q)]
    pub fn to_homogeneous(q: &Self) -> Matrix4<T> {
        let m = to_rotation_matrix(q);
        let mut homogeneous = Matrix4::<T>::identity();
        for column in 0..3 {
            for row in 0..3 {
                homogeneous[(row, column)] = m[(row, column)];
            }
        }
        homogeneous
    }

    /// The quaternion of a rotation matrix. It is computed by way of its largest part, which is the divisor.
    pub fn from_rotation_matrix(m: &Rotation3<T>) -> Self {
        let trace = m[(0, 0)] + m[(1, 1)] + m[(2, 2)];
        let two: T = real(2.0);
        let quarter: T = real(0.25);
        if trace > T::ZERO {
            let divisor = (trace + T::ONE).sqrt() * two;
            Native::new_unchecked(Quaternion::new(
                quarter * divisor,
                (m[(2, 1)] - m[(1, 2)]) / divisor,
                (m[(0, 2)] - m[(2, 0)]) / divisor,
                (m[(1, 0)] - m[(0, 1)]) / divisor,
            ))
        } else if m[(0, 0)] > m[(1, 1)] && m[(0, 0)] > m[(2, 2)] {
            let divisor = (T::ONE + m[(0, 0)] - m[(1, 1)] - m[(2, 2)]).sqrt() * two;
            Native::new_unchecked(Quaternion::new(
                (m[(2, 1)] - m[(1, 2)]) / divisor,
                quarter * divisor,
                (m[(0, 1)] + m[(1, 0)]) / divisor,
                (m[(0, 2)] + m[(2, 0)]) / divisor,
            ))
        } else if m[(1, 1)] > m[(2, 2)] {
            let divisor = (T::ONE + m[(1, 1)] - m[(0, 0)] - m[(2, 2)]).sqrt() * two;
            Native::new_unchecked(Quaternion::new(
                (m[(0, 2)] - m[(2, 0)]) / divisor,
                (m[(0, 1)] + m[(1, 0)]) / divisor,
                quarter * divisor,
                (m[(1, 2)] + m[(2, 1)]) / divisor,
            ))
        } else {
            let divisor = (T::ONE + m[(2, 2)] - m[(0, 0)] - m[(1, 1)]).sqrt() * two;
            Native::new_unchecked(Quaternion::new(
                (m[(1, 0)] - m[(0, 1)]) / divisor,
                (m[(0, 2)] + m[(2, 0)]) / divisor,
                (m[(1, 2)] + m[(2, 1)]) / divisor,
                quarter * divisor,
            ))
        }
    }

    /// Linear interpolation between `a` (`share` 0) and `b` (`share` 1), normalised to length 1.
    pub fn nlerp(a: &Self, b: &Self, share: T) -> Self {
        new_normalize(&quaternion::lerp(a, b, share))
    }

    /// The axis, in the direction for which the angle is at most π; `None` for the identity.
    pub fn axis(q: &Self) -> Option<UnitVector3<T>> {
        let vector = if q.w >= T::ZERO {
            Vector3::new(q.i, q.j, q.k)
        } else {
            Vector3::new(-q.i, -q.j, -q.k)
        };
        let squared = vector.norm_squared();
        if squared > T::ZERO { Some(Unit::new_unchecked(vector / squared.sqrt())) } else { None }
    }

    /// The rotation `q` followed by a small rotation, to first order. `axis` is the small rotation's axis times its
    /// angle, in rad.
    pub fn append_axisangle_linearized(q: &Self, axis: &Vector3<T>) -> Self {
        let half = axis * real::<T>(0.5);
        let change = quaternion::product(&quaternion::from_imag(&half), q);
        new_normalize(&quaternion::sum(q, &change))
    }

    /// Normalises to length 1 in place and returns the length before.
    pub fn renormalize(q: &mut Self) -> T {
        let length = norm_squared(q).sqrt();
        *q = Native::new_unchecked(Quaternion::new(
            q.w / length,
            q.i / length,
            q.j / length,
            q.k / length,
        ));
        length
    }

    /// Normalises a length near 1 in place, by one Newton step without a square root or a division.
    pub fn renormalize_fast(q: &mut Self) {
        let factor = real::<T>(0.5) * (real::<T>(3.0) - norm_squared(q));
        *q = Native::new_unchecked(Quaternion::new(
            q.w * factor,
            q.i * factor,
            q.j * factor,
            q.k * factor,
        ));
    }
}

/// The rotation that applies `second` and then `first`.
#[function]
pub fn product<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    let (a, b) = (first, second);
    Native::new_unchecked(Quaternion::new(
        a.w * b.w - a.i * b.i - a.j * b.j - a.k * b.k,
        a.w * b.i + a.i * b.w + a.j * b.k - a.k * b.j,
        a.w * b.j - a.i * b.k + a.j * b.w + a.k * b.i,
        a.w * b.k + a.i * b.j - a.j * b.i + a.k * b.w,
    ))
}

/// The rotation that applies the inverse of `second` and then `first`.
#[function]
pub fn quotient<T: Real>(first: &Native<T>, second: &Native<T>) -> Native<T> {
    product(first, &inverse(second))
}

/// The rotation that applies `matrix` and then `q`.
#[function]
pub fn product_with_matrix<T: Real>(q: &Native<T>, matrix: &Rotation3<T>) -> Native<T> {
    product(q, &from_rotation_matrix(matrix))
}

/// The rotation that applies the inverse of `matrix` and then `q`.
#[function]
pub fn quotient_by_matrix<T: Real>(q: &Native<T>, matrix: &Rotation3<T>) -> Native<T> {
    quotient(q, &from_rotation_matrix(matrix))
}

/// The rotation that applies `q` and then `matrix`.
#[function]
pub fn product_of_matrix<T: Real>(matrix: &Rotation3<T>, q: &Native<T>) -> Native<T> {
    product(&from_rotation_matrix(matrix), q)
}

/// The rotation that applies the inverse of `q` and then `matrix`.
#[function]
pub fn quotient_of_matrix<T: Real>(matrix: &Rotation3<T>, q: &Native<T>) -> Native<T> {
    quotient(&from_rotation_matrix(matrix), q)
}

/// The square of the length.
#[function]
fn norm_squared<T: Real>(q: &Native<T>) -> T {
    (q.i * q.i + q.k * q.k) + (q.j * q.j + q.w * q.w)
}
