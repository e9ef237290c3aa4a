//! Rotations in space: nalgebra's operations, in its order, over the DSL's own sine and cosine.
//!
//! nalgebra's constructors from angles take the platform's trigonometry, whose last bits differ between
//! targets, so the attributes refuse them. What needs no angle (product, inverse, the turn of a vector,
//! the matrix) has the bits of nalgebra's `UnitQuaternion`.
//!
//! Absent: scaling and translation. A pose is a `Turn` and a `Vector3`.

use nalgebra::{Matrix3, Vector3};

use crate::prelude::*;

/// A rotation: the unit quaternion w + i·𝐢 + j·𝐣 + k·𝐤.
///
/// ```
/// use bessemer::prelude::*;
/// use bessemer::rotation::Turn;
///
/// let level = Turn::of_euler_angles(0.0, 0.0, core::f64::consts::FRAC_PI_2);
/// let ahead = level.rotate(&Vector3::new(1.0, 0.0, 0.0));
/// assert!((ahead.y - 1.0).abs() < 1e-15);
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turn<T> {
    /// sin(angle/2) times the first component of the axis.
    pub i: T,
    /// The second.
    pub j: T,
    /// The third.
    pub k: T,
    /// cos(angle/2).
    pub w: T,
}

#[data]
impl<T: Real> Turn<T> {
    /// No rotation.
    pub fn identity() -> Turn<T> {
        Turn { i: T::ZERO, j: T::ZERO, k: T::ZERO, w: T::ONE }
    }

    /// By `roll` about x, then `pitch` about y, then `yaw` about z, rad (nalgebra's
    /// `UnitQuaternion::from_euler_angles`).
    pub fn of_euler_angles(roll: T, pitch: T, yaw: T) -> Turn<T> {
        let (sr, cr) = (roll * real(0.5)).sin_cos();
        let (sp, cp) = (pitch * real(0.5)).sin_cos();
        let (sy, cy) = (yaw * real(0.5)).sin_cos();
        Turn {
            i: sr * cp * cy - cr * sp * sy,
            j: cr * sp * cy + sr * cp * sy,
            k: cr * cp * sy - sr * sp * cy,
            w: cr * cp * cy + sr * sp * sy,
        }
    }

    /// By `angle` about an axis of length 1, rad (`UnitQuaternion::from_axis_angle`).
    pub fn about(axis: &Vector3<T>, angle: T) -> Turn<T> {
        let (sine, cosine) = (angle / real(2.0)).sin_cos();
        Turn { i: axis.x * sine, j: axis.y * sine, k: axis.z * sine, w: cosine }
    }

    /// By the length of `axis`, rad, about it (`UnitQuaternion::from_scaled_axis`); none for a length
    /// of 2ε or less.
    pub fn of_scaled_axis(axis: &Vector3<T>) -> Turn<T> {
        let half = axis / real::<T>(2.0);
        let squared = half.norm_squared();
        if squared <= T::EPSILON * T::EPSILON {
            return Turn::identity();
        }
        let angle = squared.sqrt();
        let (sine, cosine) = angle.sin_cos();
        let share = sine / angle;
        Turn { i: half.x * share, j: half.y * share, k: half.z * share, w: cosine }
    }

    /// `first`, and then this one: the product `self * first`.
    pub fn after(&self, first: &Turn<T>) -> Turn<T> {
        Turn {
            i: self.w * first.i + self.i * first.w + self.j * first.k - self.k * first.j,
            j: self.w * first.j - self.i * first.k + self.j * first.w + self.k * first.i,
            k: self.w * first.k + self.i * first.j - self.j * first.i + self.k * first.w,
            w: self.w * first.w - self.i * first.i - self.j * first.j - self.k * first.k,
        }
    }

    /// The rotation back.
    pub fn inverse(&self) -> Turn<T> {
        Turn { i: -self.i, j: -self.j, k: -self.k, w: self.w }
    }

    /// The vector turned.
    pub fn rotate(&self, vector: &Vector3<T>) -> Vector3<T> {
        let axis = Vector3::new(self.i, self.j, self.k);
        let across = axis.cross(vector) * real::<T>(2.0);
        let twice = axis.cross(&across);
        across * self.w + twice + vector
    }

    /// The vector turned back.
    pub fn rotate_back(&self, vector: &Vector3<T>) -> Vector3<T> {
        self.inverse().rotate(vector)
    }

    /// The same rotation, its quaternion brought to length 1 again.
    pub fn renormalized(&self) -> Turn<T> {
        let length =
            ((self.i * self.i + self.k * self.k) + (self.j * self.j + self.w * self.w)).sqrt();
        Turn { i: self.i / length, j: self.j / length, k: self.k / length, w: self.w / length }
    }

    /// The matrix that turns vectors so (`to_rotation_matrix`).
    pub fn matrix(&self) -> Matrix3<T> {
        let two: T = real(2.0);
        let ww = self.w * self.w;
        let ii = self.i * self.i;
        let jj = self.j * self.j;
        let kk = self.k * self.k;
        let ij = self.i * self.j * two;
        let wk = self.w * self.k * two;
        let wj = self.w * self.j * two;
        let ik = self.i * self.k * two;
        let jk = self.j * self.k * two;
        let wi = self.w * self.i * two;
        Matrix3::new(
            ww + ii - jj - kk,
            ij - wk,
            wj + ik,
            wk + ij,
            ww - ii + jj - kk,
            jk - wi,
            ik - wj,
            wi + jk,
            ww - ii - jj + kk,
        )
    }

    /// Roll, pitch and yaw, rad, pitch from −π/2 to π/2; at its ends yaw is 0 (`euler_angles`).
    pub fn roll_pitch_yaw(&self) -> Vector3<T> {
        let m = self.matrix();
        let down = m[(2, 0)];
        let quarter = T::PI * real(0.5);
        if down.abs() < T::ONE {
            let pitch = -down.asin();
            let cosine = pitch.cos();
            Vector3::new(
                (m[(2, 1)] / cosine).atan2(m[(2, 2)] / cosine),
                pitch,
                (m[(1, 0)] / cosine).atan2(m[(0, 0)] / cosine),
            )
        } else if down <= -T::ONE {
            Vector3::new(m[(0, 1)].atan2(m[(0, 2)]), quarter, T::ZERO)
        } else {
            Vector3::new(-m[(0, 1)].atan2(-m[(0, 2)]), -quarter, T::ZERO)
        }
    }

    /// The rotation `share` of the way to `other`, by the shorter way (`slerp`); this one, if both are
    /// the same.
    pub fn towards(&self, other: &Turn<T>, share: T) -> Turn<T> {
        let along = (self.i * other.i + self.k * other.k) + (self.j * other.j + self.w * other.w);
        let opposite = along < T::ZERO;
        let cosine = along.abs();
        let sine = (T::ONE - cosine * cosine).sqrt();
        // Also where both are too near to each other for a direction.
        if cosine >= T::ONE || sine == T::ZERO {
            return *self;
        }
        let angle = cosine.acos();
        let own = ((T::ONE - share) * angle).sin() / sine;
        let part = (share * angle).sin() / sine;
        let theirs = if opposite { -part } else { part };
        Turn {
            i: theirs * other.i + own * self.i,
            j: theirs * other.j + own * self.j,
            k: theirs * other.k + own * self.k,
            w: theirs * other.w + own * self.w,
        }
    }
}
