//! The aircraft's orientation: frames, angles and their rates (thesis, ch. 2).
//!
//! Frames: z of the inertial frame points upwards; x of the body points forward, its z along the thrust; both frames
//! are right-handed. Angles: R = C1(roll) C2(pitch) C3(yaw) of a passive rotation, so a positive body rate decreases
//! them. Forces and control are unknown here.

use bessemer::prelude::*;
use core::f64::consts::PI;

/// Least cosine of the pitch used as a divisor: 89.4°.
#[data]
pub const LEAST_PITCH_COSINE: f64 = 0.01;

/// Sines and cosines of roll θ1, pitch θ2 and yaw θ3, the angles of R = C1(θ1) C2(θ2) C3(θ3).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Orientation {
    /// sin θ1.
    pub s1: f64,
    /// cos θ1.
    pub c1: f64,
    /// sin θ2.
    pub s2: f64,
    /// cos θ2.
    pub c2: f64,
    /// sin θ3.
    pub s3: f64,
    /// cos θ3.
    pub c3: f64,
}

#[data]
impl Orientation {
    /// Returns the orientation for roll, pitch and yaw, rad.
    pub fn of(angles: &Vector3<f64>) -> Orientation {
        let (s1, c1) = angles.x.sin_cos();
        let (s2, c2) = angles.y.sin_cos();
        let (s3, c3) = angles.z.sin_cos();
        Orientation { s1, c1, s2, c2, s3, c3 }
    }

    /// Rotation from the body frame to the inertial frame: R = C1(roll) C2(pitch) C3(yaw) (thesis, eq. (2.11)).
    ///
    /// Each Ci is the passive rotation about axis i: it turns the axes and not the vector, so that a positive yaw
    /// turns the body's x towards −y. Both frames are right-handed: the inertial one's z points upwards; the
    /// body's x forward, its y to the left, its z along the thrust.
    #[rustfmt::skip]
    pub fn rotation(&self) -> Matrix3<f64> {
        let s1 = self.s1;
        let c1 = self.c1;
        let s2 = self.s2;
        let c2 = self.c2;
        let s3 = self.s3;
        let c3 = self.c3;
        Matrix3::new(
            c2 * c3,                c2 * s3,                -s2,
            s1 * s2 * c3 - c1 * s3, s1 * s2 * s3 + c1 * c3, s1 * c2,
            c1 * s2 * c3 + s1 * s3, c1 * s2 * s3 - s1 * c3, c1 * c2,
        )
    }

    /// Returns the direction of the body's z in the inertial frame: the third column of
    /// [`rotation`](Orientation::rotation).
    pub fn thrust_direction(&self) -> Vector3<f64> {
        Vector3::new(-self.s2, self.s1 * self.c2, self.c1 * self.c2)
    }

    /// Returns the direction of the inertial frame's z in the body frame: the third row of
    /// [`rotation`](Orientation::rotation) (thesis, eq. (4.7)).
    pub fn upwards(&self) -> Vector3<f64> {
        Vector3::new(
            self.c1 * self.s2 * self.c3 + self.s1 * self.s3,
            self.c1 * self.s2 * self.s3 - self.s1 * self.c3,
            self.c1 * self.c2,
        )
    }

    /// Body rates per rate of the angles: T in ω = T θ̇ (thesis, eq. (2.16)), with ω about the body's x, y and z by the
    /// right-hand rule and θ̇ in the order roll, pitch, yaw. Level, T is diag(−1, −1, −1): the angles are passive.
    ///
    /// Its columns are the axes about which roll, pitch and yaw turn, seen from the body.
    #[rustfmt::skip]
    pub fn rate_matrix(&self) -> Matrix3<f64> {
        Matrix3::new(
            -self.c2 * self.c3,  self.s3,  0.0,
            -self.c2 * self.s3, -self.c3,  0.0,
             self.s2,            0.0,     -1.0,
        )
    }

    /// Returns cos θ2 as a divisor, at least 0.01 in magnitude, so that rates stay finite at a pitch of ±π/2.
    #[requirement("HLR-26")]
    pub fn divisor(&self) -> f64 {
        if self.c2.abs() < LEAST_PITCH_COSINE {
            return LEAST_PITCH_COSINE.copysign(self.c2);
        }
        self.c2
    }

    /// Rates of the angles at the given body rates (thesis, eq. (2.17)), rad/s.
    ///
    /// Singular at a pitch of ±π/2: the divisor is limited.
    pub fn angle_rates(&self, body_rates: &Vector3<f64>) -> Vector3<f64> {
        let along = self.c3 * body_rates.x + self.s3 * body_rates.y;
        let across = self.s3 * body_rates.x - self.c3 * body_rates.y;
        let roll_rate = -along / self.divisor();
        Vector3::new(roll_rate, across, self.s2 * roll_rate - body_rates.z)
    }
}

/// Returns the angle reduced to ±π, rad.
#[function]
pub fn wrapped(angle: f64) -> f64 {
    if angle.abs() <= PI {
        return angle;
    }
    (angle + PI).rem_euclid(2.0 * PI) - PI
}
