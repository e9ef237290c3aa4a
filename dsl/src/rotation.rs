//! Rotations from angles, and angles from rotations: nalgebra's operations, in its order, over the DSL's own
//! sine and cosine.
//!
//! nalgebra's own take the platform's trigonometry, whose last bits differ between targets, so the
//! attributes put these in their place: `UnitQuaternion::from_euler_angles`, `q.slerp(…)`. Everything else of a `UnitQuaternion`, a `Rotation3` or an `Isometry3` is
//! nalgebra's own. Each function has the name of nalgebra's; angles are in rad.
//!
//! ```
//! use bessemer::nalgebra::{UnitQuaternion, Vector3};
//! use bessemer::rotation;
//!
//! let level = rotation::from_euler_angles(0.0, 0.0, core::f64::consts::FRAC_PI_2);
//! let ahead: Vector3<f64> = level * Vector3::new(1.0, 0.0, 0.0);
//! assert!((ahead.y - 1.0).abs() < 1e-15);
//! ```

use nalgebra::{
    Matrix2, Matrix3, Quaternion, Rotation2, Rotation3, UnitQuaternion, UnitVector3, Vector3,
};

use crate::library;
use crate::prelude::*;

#[library(TurnCompanions)]
impl<T: Real> UnitQuaternion<T> {
    /// The rotation about `axis` by its length, in rad; the identity for a length of 2ε or less. Also nalgebra's
    /// `UnitQuaternion::new`.
    #[method(dsl_new, from_scaled_axis)]
    pub fn from_scaled_axis(axis: Vector3<T>) -> Self {
        let half = axis / real::<T>(2.0);
        let squared = half.norm_squared();
        if squared <= T::EPSILON * T::EPSILON {
            return UnitQuaternion::identity();
        }
        let angle = squared.sqrt();
        let (sine, cosine) = angle.sin_cos();
        let share = sine / angle;
        UnitQuaternion::new_unchecked(Quaternion::new(
            cosine,
            half.x * share,
            half.y * share,
            half.z * share,
        ))
    }

    /// The rotation about an axis by `angle`, in rad.
    pub fn from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
        let (sine, cosine) = (angle / real(2.0)).sin_cos();
        UnitQuaternion::new_unchecked(Quaternion::new(
            cosine,
            axis.x * sine,
            axis.y * sine,
            axis.z * sine,
        ))
    }

    /// The rotation by `roll` about x, then `pitch` about y, then `yaw` about z, in rad.
    pub fn from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
        let (sr, cr) = (roll * real(0.5)).sin_cos();
        let (sp, cp) = (pitch * real(0.5)).sin_cos();
        let (sy, cy) = (yaw * real(0.5)).sin_cos();
        UnitQuaternion::new_unchecked(Quaternion::new(
            cr * cp * cy + sr * sp * sy,
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
        ))
    }

    /// The smallest rotation from `a` to `b`; `None` if they are opposite, so that any axis would do.
    pub fn rotation_between_axis(a: &UnitVector3<T>, b: &UnitVector3<T>) -> Option<Self> {
        scaled_rotation_between_axis(a, b, T::ONE)
    }

    /// The rotation from one direction to another, its angle multiplied by `share`.
    pub fn scaled_rotation_between_axis(
        a: &UnitVector3<T>,
        b: &UnitVector3<T>,
        share: T,
    ) -> Option<Self> {
        let across = a.cross(b);
        let cosine = a.dot(b);
        let squared = across.norm_squared();
        if squared > T::EPSILON * T::EPSILON {
            if cosine <= -T::ONE {
                return None;
            }
            if cosine < T::ONE {
                let axis = UnitVector3::new_unchecked(across / squared.sqrt());
                return Some(from_axis_angle(&axis, cosine.acos() * share));
            }
        } else if cosine < T::ZERO {
            return None;
        }
        Some(UnitQuaternion::identity())
    }

    /// The smallest rotation from the direction of `a` to the direction of `b`. `None` if they are opposite; the
    /// identity if one of them is zero.
    pub fn rotation_between(a: &Vector3<T>, b: &Vector3<T>) -> Option<Self> {
        scaled_rotation_between(a, b, T::ONE)
    }

    /// The smallest rotation from the direction of `a` to the direction of `b`, with its angle multiplied by `share`.
    pub fn scaled_rotation_between(a: &Vector3<T>, b: &Vector3<T>, share: T) -> Option<Self> {
        match (UnitVector3::try_new(*a, T::ZERO), UnitVector3::try_new(*b, T::ZERO)) {
            (Some(from), Some(to)) => scaled_rotation_between_axis(&from, &to, share),
            _ => Some(UnitQuaternion::identity()),
        }
    }

    /// The rotation about the same axis, with its angle multiplied by `share`.
    pub fn powf(q: &Self, share: T) -> Self {
        match q.axis() {
            Some(axis) => from_axis_angle(&axis, angle(q) * share),
            None => UnitQuaternion::identity(),
        }
    }

    /// Spherical interpolation from `a` to `b` by the shorter arc, at `share`. It is `a` if the two are too near to
    /// each other for an axis (where nalgebra panics).
    pub fn slerp(a: &Self, b: &Self, share: T) -> Self {
        let along = (a.i * b.i + a.k * b.k) + (a.j * b.j + a.w * b.w);
        let opposite = along < T::ZERO;
        let cosine = along.abs();
        let sine = (T::ONE - cosine * cosine).sqrt();
        if cosine >= T::ONE || sine == T::ZERO {
            return *a;
        }
        let angle = cosine.acos();
        let own = ((T::ONE - share) * angle).sin() / sine;
        let part = (share * angle).sin() / sine;
        let theirs = if opposite { -part } else { part };
        UnitQuaternion::new_unchecked(Quaternion::new(
            theirs * b.w + own * a.w,
            theirs * b.i + own * a.i,
            theirs * b.j + own * a.j,
            theirs * b.k + own * a.k,
        ))
    }

    /// The axis and the angle in rad; `None` for the identity.
    pub fn axis_angle(q: &Self) -> Option<(UnitVector3<T>, T)> {
        let axis = q.axis()?;
        Some((axis, angle(q)))
    }

    /// The axis times the angle, rad.
    pub fn scaled_axis(q: &Self) -> Vector3<T> {
        match q.axis() {
            Some(axis) => axis.into_inner() * angle(q),
            None => Vector3::zeros(),
        }
    }

    /// Roll, pitch and yaw, rad, pitch from −π/2 to π/2; at its ends yaw is 0.
    pub fn euler_angles(q: &Self) -> (T, T, T) {
        matrix_euler_angles(&q.to_rotation_matrix())
    }
}

/// Angle of a rotation, rad, from 0 to π.
#[function]
pub fn angle<T: Real>(q: &UnitQuaternion<T>) -> T {
    Vector3::new(q.i, q.j, q.k).norm().atan2(q.w.abs()) * real(2.0)
}

/// Angle of the rotation from `from` to `to`, rad.
#[function]
pub fn angle_to<T: Real>(from: &UnitQuaternion<T>, to: &UnitQuaternion<T>) -> T {
    angle(&from.rotation_to(to))
}

#[library(PlaneRotationCompanion)]
impl<T: Real> Rotation2<T> {
    /// The matrix of a rotation in the plane by `angle`, in rad (`Rotation2::new`).
    #[method(dsl_new)]
    pub fn matrix_from_angle(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Rotation2::from_matrix_unchecked(Matrix2::new(cosine, -sine, sine, cosine))
    }
}

#[library(SpaceRotationCompanions)]
impl<T: Real> Rotation3<T> {
    /// The matrix of a rotation about `axis` by its length, in rad (`Rotation3::from_scaled_axis` and
    /// `Rotation3::new`).
    #[method(dsl_new, from_scaled_axis)]
    pub fn matrix_from_scaled_axis(axis: Vector3<T>) -> Self {
        let angle = axis.norm();
        matrix_from_axis_angle(&UnitVector3::new_unchecked(axis / angle), angle)
    }

    /// The matrix of a rotation about an axis by an angle, in rad (`Rotation3::from_axis_angle`).
    #[method(from_axis_angle)]
    pub fn matrix_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
        if angle == T::ZERO {
            return Rotation3::identity();
        }
        let (x, y, z) = (axis.x, axis.y, axis.z);
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let (sine, cosine) = angle.sin_cos();
        let rest = T::ONE - cosine;
        Rotation3::from_matrix_unchecked(Matrix3::new(
            xx + (T::ONE - xx) * cosine,
            x * y * rest - z * sine,
            x * z * rest + y * sine,
            x * y * rest + z * sine,
            yy + (T::ONE - yy) * cosine,
            y * z * rest - x * sine,
            x * z * rest - y * sine,
            y * z * rest + x * sine,
            zz + (T::ONE - zz) * cosine,
        ))
    }

    /// The matrix of `roll` about x, then `pitch` about y, then `yaw` about z, rad
    /// (`Rotation3::from_euler_angles`).
    #[method(from_euler_angles)]
    pub fn matrix_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
        let (sr, cr) = roll.sin_cos();
        let (sp, cp) = pitch.sin_cos();
        let (sy, cy) = yaw.sin_cos();
        Rotation3::from_matrix_unchecked(Matrix3::new(
            cy * cp,
            cy * sp * sr - sy * cr,
            cy * sp * cr + sy * sr,
            sy * cp,
            sy * sp * sr + cy * cr,
            sy * sp * cr - cy * sr,
            -sp,
            cp * sr,
            cp * cr,
        ))
    }

    /// Roll, pitch and yaw of a matrix, rad, pitch from −π/2 to π/2; at its ends yaw is 0
    /// (`Rotation3::euler_angles`).
    #[method(euler_angles)]
    pub fn matrix_euler_angles(m: &Self) -> (T, T, T) {
        let down = m[(2, 0)];
        let quarter = T::PI * real(0.5);
        if down.abs() < T::ONE {
            let pitch = -down.asin();
            let cosine = pitch.cos();
            (
                (m[(2, 1)] / cosine).atan2(m[(2, 2)] / cosine),
                pitch,
                (m[(1, 0)] / cosine).atan2(m[(0, 0)] / cosine),
            )
        } else if down <= -T::ONE {
            (m[(0, 1)].atan2(m[(0, 2)]), quarter, T::ZERO)
        } else {
            (-m[(0, 1)].atan2(-m[(0, 2)]), -quarter, T::ZERO)
        }
    }
}

/// Rotation methods that the attributes call instead of nalgebra's methods of the same names.
#[doc(hidden)]
pub trait RotationMethods<T> {
    /// Calls [`powf`].
    fn dsl_powf(&self, share: T) -> Self;
    /// Calls [`slerp`].
    fn dsl_slerp(&self, other: &Self, share: T) -> Self;
    /// Calls [`axis_angle`].
    fn dsl_axis_angle(&self) -> Option<(UnitVector3<T>, T)>;
    /// Calls [`scaled_axis`].
    fn dsl_scaled_axis(&self) -> Vector3<T>;
}

impl<T: Real> RotationMethods<T> for UnitQuaternion<T> {
    fn dsl_powf(&self, share: T) -> Self {
        powf(self, share)
    }
    fn dsl_slerp(&self, other: &Self, share: T) -> Self {
        slerp(self, other, share)
    }
    fn dsl_axis_angle(&self) -> Option<(UnitVector3<T>, T)> {
        axis_angle(self)
    }
    fn dsl_scaled_axis(&self) -> Vector3<T> {
        scaled_axis(self)
    }
}

/// Methods that unit quaternions and rotation matrices share.
#[doc(hidden)]
pub trait EulerMethods<T> {
    /// Calls [`euler_angles`] or [`matrix_euler_angles`].
    fn dsl_euler_angles(&self) -> (T, T, T);
}

impl<T: Real> EulerMethods<T> for UnitQuaternion<T> {
    fn dsl_euler_angles(&self) -> (T, T, T) {
        euler_angles(self)
    }
}

impl<T: Real> EulerMethods<T> for Rotation3<T> {
    fn dsl_euler_angles(&self) -> (T, T, T) {
        matrix_euler_angles(self)
    }
}

/// Rotations from angles, which the attributes call instead of nalgebra's functions of the same names.
#[doc(hidden)]
pub trait AngleMethods<T> {
    /// Calls [`from_axis_angle`] or [`matrix_from_axis_angle`].
    fn dsl_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self;
    /// Calls [`from_euler_angles`] or [`matrix_from_euler_angles`].
    fn dsl_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self;
    /// Calls [`from_scaled_axis`] or [`matrix_from_scaled_axis`].
    fn dsl_from_scaled_axis(axis: Vector3<T>) -> Self;
}

impl<T: Real> AngleMethods<T> for UnitQuaternion<T> {
    fn dsl_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
        from_axis_angle(axis, angle)
    }
    fn dsl_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
        from_euler_angles(roll, pitch, yaw)
    }
    fn dsl_from_scaled_axis(axis: Vector3<T>) -> Self {
        from_scaled_axis(axis)
    }
}

impl<T: Real> AngleMethods<T> for Rotation3<T> {
    fn dsl_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
        matrix_from_axis_angle(axis, angle)
    }
    fn dsl_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
        matrix_from_euler_angles(roll, pitch, yaw)
    }
    fn dsl_from_scaled_axis(axis: Vector3<T>) -> Self {
        matrix_from_scaled_axis(axis)
    }
}

/// Rotations between two directions, which the attributes call instead of nalgebra's functions of the same names.
#[doc(hidden)]
pub trait BetweenMethods<T>: Sized {
    /// Calls [`rotation_between_axis`].
    fn dsl_rotation_between_axis(a: &UnitVector3<T>, b: &UnitVector3<T>) -> Option<Self>;
    /// Calls [`scaled_rotation_between_axis`].
    fn dsl_scaled_rotation_between_axis(
        a: &UnitVector3<T>,
        b: &UnitVector3<T>,
        share: T,
    ) -> Option<Self>;
    /// Calls [`rotation_between`].
    fn dsl_rotation_between(a: &Vector3<T>, b: &Vector3<T>) -> Option<Self>;
    /// Calls [`scaled_rotation_between`].
    fn dsl_scaled_rotation_between(a: &Vector3<T>, b: &Vector3<T>, share: T) -> Option<Self>;
}

impl<T: Real> BetweenMethods<T> for UnitQuaternion<T> {
    fn dsl_rotation_between_axis(a: &UnitVector3<T>, b: &UnitVector3<T>) -> Option<Self> {
        rotation_between_axis(a, b)
    }
    fn dsl_scaled_rotation_between_axis(
        a: &UnitVector3<T>,
        b: &UnitVector3<T>,
        share: T,
    ) -> Option<Self> {
        scaled_rotation_between_axis(a, b, share)
    }
    fn dsl_rotation_between(a: &Vector3<T>, b: &Vector3<T>) -> Option<Self> {
        rotation_between(a, b)
    }
    fn dsl_scaled_rotation_between(a: &Vector3<T>, b: &Vector3<T>, share: T) -> Option<Self> {
        scaled_rotation_between(a, b, share)
    }
}

/// The argument of `new` of nalgebra's rotations: an angle, or an axis whose length is the angle.
#[doc(hidden)]
pub trait TurnMethods<A> {
    /// Calls [`from_scaled_axis`], [`matrix_from_angle`] or [`matrix_from_scaled_axis`].
    fn dsl_new(turn: A) -> Self;
}

impl<T: Real> TurnMethods<Vector3<T>> for UnitQuaternion<T> {
    fn dsl_new(turn: Vector3<T>) -> Self {
        from_scaled_axis(turn)
    }
}

impl<T: Real> TurnMethods<T> for Rotation2<T> {
    fn dsl_new(turn: T) -> Self {
        matrix_from_angle(turn)
    }
}

impl<T: Real> TurnMethods<Vector3<T>> for Rotation3<T> {
    fn dsl_new(turn: Vector3<T>) -> Self {
        matrix_from_scaled_axis(turn)
    }
}
