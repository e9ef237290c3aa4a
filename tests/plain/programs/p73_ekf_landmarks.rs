//! Extended Kalman filter for a differential-drive robot that observes range
//! and bearing of known landmarks.

use core::f32::consts::{PI, TAU};
use nalgebra::{ComplexField, Matrix2, Matrix2x3, Matrix3, Point2, RealField, Vector2, Vector3};

/// Wraps an angle into -π..=π.
pub fn wrap_angle(angle: f32) -> f32 {
    angle - ((angle + PI) / TAU).floor() * TAU
}

/// Distances travelled by the two wheels since the last update.
#[derive(Debug, Clone, Copy)]
pub struct Odometry {
    pub left: f32,
    pub right: f32,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    pub landmark: usize,
    pub range: f32,
    /// Relative to the heading, positive to the left.
    pub bearing: f32,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rejection {
    UnknownLandmark,
    /// Squared Mahalanobis distance beyond the gate.
    Outlier(f32),
    Singular,
}

#[derive(Debug, Clone, Copy)]
pub struct Noise {
    /// Standard deviation of wheel travel per square root of a metre.
    pub slip: f32,
    pub range: f32,
    pub bearing: f32,
}

pub struct Localizer<'m> {
    landmarks: &'m [Point2<f32>],
    noise: Noise,
    track: f32,
    /// x, y and heading.
    pose: Vector3<f32>,
    covariance: Matrix3<f32>,
}

impl<'m> Localizer<'m> {
    /// 99 % quantile of the chi-squared distribution with two degrees.
    const GATE: f32 = 9.21;

    /// Starts at the origin of the map.
    pub fn new(landmarks: &'m [Point2<f32>], track: f32, noise: Noise) -> Self {
        let covariance = Matrix3::from_diagonal_element(0.01);
        Self { landmarks, noise, track, pose: Vector3::zeros(), covariance }
    }

    pub fn pose(&self) -> &Vector3<f32> {
        &self.pose
    }

    pub fn position_sigma(&self) -> f32 {
        self.covariance.fixed_view::<2, 2>(0, 0).trace().sqrt()
    }

    pub fn predict(&mut self, odometry: &Odometry) {
        let Odometry { left, right } = *odometry;
        let distance = 0.5 * (left + right);
        let turn = (right - left) / self.track;
        // The chord of the arc points along the mean heading.
        let (sin, cos) = (self.pose.z + 0.5 * turn).sin_cos();

        #[rustfmt::skip]
        let f = Matrix3::new(
            1.0, 0.0, -distance * sin,
            0.0, 1.0, distance * cos,
            0.0, 0.0, 1.0,
        );
        let slip = (left.abs() + right.abs()) * self.noise.slip * self.noise.slip;
        let q = Vector3::new(slip, slip, slip / (self.track * self.track));

        self.pose += Vector3::new(distance * cos, distance * sin, turn);
        self.pose.z = wrap_angle(self.pose.z);
        self.covariance = f * self.covariance * f.transpose() + Matrix3::from_diagonal(&q);
    }

    /// Expected range and bearing of a landmark and their Jacobian.
    fn expect(&self, landmark: &Point2<f32>) -> (Vector2<f32>, Matrix2x3<f32>) {
        const MIN_RANGE: f32 = 0.05;
        let delta = landmark.coords - self.pose.xy();
        let range = delta.norm().max(MIN_RANGE);
        let bearing = wrap_angle(delta.y.atan2(delta.x) - self.pose.z);
        let (ux, uy) = (delta.x / range, delta.y / range);
        #[rustfmt::skip]
        let jacobian = Matrix2x3::new(
            -ux, -uy, 0.0,
            uy / range, -ux / range, -1.0,
        );
        (Vector2::new(range, bearing), jacobian)
    }

    /// Corrects the pose with one observation.
    pub fn observe(&mut self, observation: &Observation) -> Result<(), Rejection> {
        let landmark =
            self.landmarks.get(observation.landmark).ok_or(Rejection::UnknownLandmark)?;
        let (expected, h) = self.expect(landmark);

        let mut innovation = Vector2::new(observation.range, observation.bearing) - expected;
        innovation.y = wrap_angle(innovation.y);

        let sigmas = Vector2::new(self.noise.range, self.noise.bearing);
        let r = Matrix2::from_diagonal(&sigmas.component_mul(&sigmas));
        let s = h * self.covariance * h.transpose() + r;
        let s_inverse = s.try_inverse().ok_or(Rejection::Singular)?;

        let distance = innovation.dot(&(s_inverse * innovation));
        if distance > Self::GATE {
            return Err(Rejection::Outlier(distance));
        }
        let gain = self.covariance * h.transpose() * s_inverse;
        self.pose += gain * innovation;
        self.pose.z = wrap_angle(self.pose.z);

        let keep = Matrix3::identity() - gain * h;
        self.covariance = keep * self.covariance * keep.transpose() + gain * r * gain.transpose();
        Ok(())
    }
}
